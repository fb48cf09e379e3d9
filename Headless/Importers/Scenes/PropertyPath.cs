using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>Sets one value of an object by the <c>propertyPath</c> of a prefab override: <c>m_LocalPosition.x</c>, <c>regions.Array.data[2].size</c>, <c>regions.Array.size</c>.</summary>
public static partial class PropertyPath
{
    [GeneratedRegex(@"^data\[(\d+)\]$")]
    private static partial Regex Element();

    public static void Set(YamlMap body, string path, YamlNode value)
    {
        string[] parts = path.Split('.');
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
                    Resize(list, (int)YamlValue.Long(((YamlScalar)value).Text, path));
                    return;
                }
                int index = Index(access, path);
                if (index >= list.Items.Count) Resize(list, index + 1);
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
            if (map.Map(parts[i]) is not { } next) map.Set(parts[i], next = new YamlMap());
            map = next;
        }
    }

    private static YamlList ListAt(YamlMap map, string key, string path)
    {
        if (map[key] is YamlList list) return list;
        if (map[key] is YamlScalar { Text.Length: > 0 } packed)
            throw new FormatException($"the override '{path}' changes one element of an array that the prefab stores packed ('{packed.Text}'); override the prefab itself instead.");
        list = new YamlList();
        map.Set(key, list);
        return list;
    }

    private static int Index(string access, string path)
    {
        Match match = Element().Match(access);
        return match.Success ? int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture) : throw new FormatException($"the property path '{path}' is not understood.");
    }

    /// <summary>As the Inspector does, new elements copy the last one.</summary>
    private static void Resize(YamlList list, int size)
    {
        if (size < list.Items.Count) list.Items.RemoveRange(size, list.Items.Count - size);
        while (list.Items.Count < size) list.Items.Add(list.Items.Count > 0 ? list.Items[^1].Clone() : new YamlScalar(""));
    }
}
