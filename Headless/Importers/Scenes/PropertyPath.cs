using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Files;
using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>Sets one value of an object by the <c>propertyPath</c> of a prefab override: <c>m_LocalPosition.x</c>, <c>regions.Array.data[2].size</c>, <c>regions.Array.size</c>.</summary>
public static partial class PropertyPath
{
    private const int DeepestPath = 128;

    [GeneratedRegex(@"^data\[(\d+)\]$")]
    private static partial Regex Element();

    /// <exception cref="FormatException">The path does not fit the object.</exception>
    public static void Set(YamlMap body, string path, YamlNode value, ValueBudget budget)
    {
        string[] parts = path.Split('.');
        if (parts.Length > DeepestPath) throw new FormatException($"the property path '{OneLine.Value(path)}' has more than {DeepestPath} parts; the override is left out.");
        budget.Take(parts.Length);
        YamlMap map = body;
        for (int i = 0; i < parts.Length; i++)
        {
            if (i + 2 < parts.Length && parts[i + 1] == "Array")
            {
                YamlList list = ListAt(map, parts[i], path);
                string access = parts[i + 2];
                i += 2;
                if (access == "size")
                {
                    Resize(list, Size(value, path), budget);
                    return;
                }
                int index = Index(access, path);
                if (index >= list.Items.Count) Resize(list, index + 1L, budget);
                if (i == parts.Length - 1)
                {
                    list.Items[index] = value;
                    return;
                }
                if (list.Items[index] is not YamlMap element) list.Items[index] = element = new YamlMap();
                map = element;
                continue;
            }
            if (i == parts.Length - 1)
            {
                map.Set(parts[i], value);
                return;
            }
            if (map[parts[i]] is not YamlMap next) map.Set(parts[i], next = new YamlMap());
            map = next;
        }
    }

    private static YamlList ListAt(YamlMap map, string key, string path)
    {
        if (map[key] is YamlList list) return list;
        if (map[key] is YamlScalar { Text.Length: > 0 } packed)
            throw new FormatException($"the override '{OneLine.Value(path)}' changes one element of an array that the prefab stores packed ('{OneLine.Value(packed.Text)}'); override the prefab itself instead.");
        list = new YamlList();
        map.Set(key, list);
        return list;
    }

    /// <summary>The index in <c>data[3]</c>; null when it is something else.</summary>
    public static int? IndexOf(string access) =>
        Element().Match(access) is { Success: true } match && int.TryParse(match.Groups[1].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out int index)
            ? index
            : null;

    private static int Index(string access, string path) =>
        IndexOf(access) ?? throw new FormatException($"the property path '{OneLine.Value(path)}' is not understood; the override is left out.");

    private static long Size(YamlNode value, string path)
    {
        if (value is YamlScalar text && YamlValue.Long(text, path) is >= 0 and var size) return size;
        throw new FormatException($"the override '{OneLine.Value(path)}' is no size of an array; it is left out.");
    }

    /// <summary>As the Inspector does, new elements copy the last one.</summary>
    private static void Resize(YamlList list, long size, ValueBudget budget)
    {
        if (size < list.Items.Count) list.Items.RemoveRange((int)size, list.Items.Count - (int)size);
        budget.Take((size - list.Items.Count) * (list.Items.Count > 0 ? list.Items[^1].Weight : 1));
        while (list.Items.Count < size) list.Items.Add(list.Items.Count > 0 ? list.Items[^1].Clone() : new YamlScalar(""));
    }
}
