using System.Globalization;

namespace Headless.Importers.Yaml;

/// <summary>A mapping in file order. Getters return the default given for a missing key, as Unity does on load.</summary>
public sealed class YamlMap : YamlNode
{
    private readonly List<KeyValuePair<string, YamlNode>> entries = [];
    private readonly Dictionary<string, int> positions = [];

    public IReadOnlyList<KeyValuePair<string, YamlNode>> Entries => entries;
    public int Count => entries.Count;

    public YamlNode? this[string key] => positions.TryGetValue(key, out int at) ? entries[at].Value : null;

    public bool Has(string key) => positions.ContainsKey(key);

    public void Set(string key, YamlNode value)
    {
        if (positions.TryGetValue(key, out int at))
        {
            entries[at] = new(key, value);
            return;
        }
        positions[key] = entries.Count;
        entries.Add(new(key, value));
    }

    public YamlMap? Map(string key) => this[key] as YamlMap;

    public IReadOnlyList<YamlNode> List(string key) => this[key] is YamlList list ? list.Items : [];

    public string Text(string key, string absent = "") => this[key] is YamlScalar scalar ? scalar.Text : absent;

    public float Float(string key, float absent = 0) => this[key] is YamlScalar { Text.Length: > 0 } s ? YamlValue.Float(s.Text, key) : absent;

    public int Int(string key, int absent = 0) => this[key] is YamlScalar { Text.Length: > 0 } s ? (int)YamlValue.Long(s.Text, key) : absent;

    public long Long(string key, long absent = 0) => this[key] is YamlScalar { Text.Length: > 0 } s ? YamlValue.Long(s.Text, key) : absent;

    public bool Bool(string key, bool absent = false) => this[key] is YamlScalar { Text.Length: > 0 } s ? YamlValue.Bool(s.Text, key) : absent;

    public override YamlNode Clone()
    {
        var copy = new YamlMap();
        foreach (var (key, value) in entries) copy.Set(key, value.Clone());
        return copy;
    }

    public override string ToString() => "{" + string.Join(", ", entries.Select(e => string.Create(CultureInfo.InvariantCulture, $"{e.Key}: {e.Value}"))) + "}";
}
