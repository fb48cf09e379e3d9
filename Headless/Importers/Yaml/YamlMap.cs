using System.Globalization;
using Headless.Files;
using Headless.Importers.Scenes;

namespace Headless.Importers.Yaml;

/// <summary>
/// A mapping in file order. Getters return the default given for a missing or empty key, as Unity does on load; a value of
/// another kind is an error with its line.
/// </summary>
public sealed class YamlMap(YamlPlace place = default) : YamlNode(place)
{
    private readonly List<KeyValuePair<string, YamlNode>> entries = [];
    private readonly Dictionary<string, int> positions = [];

    public IReadOnlyList<KeyValuePair<string, YamlNode>> Entries => entries;
    public int Count => entries.Count;
    public override long Weight => 1 + entries.Sum(e => e.Value.Weight);
    public override string Kind => "a mapping";

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

    /// <exception cref="ImportException">It is no mapping.</exception>
    public YamlMap? Map(string key) => this[key] switch
    {
        null or YamlScalar { IsEmpty: true } or YamlList { Items.Count: 0 } => null,
        YamlMap map => map,
        { } other => throw WrongKind(key, other, "a mapping"),
    };

    /// <exception cref="ImportException">It is no list.</exception>
    public IReadOnlyList<YamlNode> List(string key) => this[key] switch
    {
        null or YamlScalar { IsEmpty: true } or YamlMap { Count: 0 } => [],
        YamlList list => list.Items,
        { } other => throw WrongKind(key, other, "a list"),
    };

    /// <summary>The mappings of a list.</summary>
    /// <exception cref="ImportException">It is no list, or an item is no mapping.</exception>
    public IEnumerable<YamlMap> Maps(string key) =>
        List(key).Select(item => item as YamlMap ?? throw WrongKind(key, item, "a list of mappings"));

    /// <summary>The texts of a list.</summary>
    /// <exception cref="ImportException">It is no list, or an item is no single value.</exception>
    public IEnumerable<string> Texts(string key) =>
        List(key).Select(item => (item as YamlScalar ?? throw WrongKind(key, item, "a list of single values")).Text);

    public string Text(string key, string absent = "") => Scalar(key)?.Text ?? absent;

    public float Float(string key, float absent = 0) => Given(key) is { } s ? YamlValue.Float(s, key) : absent;

    public int Int(string key, int absent = 0) => Given(key) is { } s ? YamlValue.Int(s, key) : absent;

    public long Long(string key, long absent = 0) => Given(key) is { } s ? YamlValue.Long(s, key) : absent;

    public bool Bool(string key, bool absent = false) => Given(key) is { } s ? YamlValue.Bool(s, key) : absent;

    public override YamlNode Clone()
    {
        var copy = new YamlMap(Place);
        foreach (var (key, value) in entries) copy.Set(key, value.Clone());
        return copy;
    }

    public override string ToString() => "{" + string.Join(", ", entries.Select(e => string.Create(CultureInfo.InvariantCulture, $"{e.Key}: {e.Value}"))) + "}";

    private YamlScalar? Given(string key) => Scalar(key) is { IsEmpty: false } scalar ? scalar : null;

    private YamlScalar? Scalar(string key) => this[key] switch
    {
        null or ScopedReference or YamlMap { Count: 0 } or YamlList { Items.Count: 0 } => null,
        YamlScalar scalar => scalar,
        { } other => throw WrongKind(key, other, "a single value"),
    };

    private ImportException WrongKind(string key, YamlNode found, string expected)
    {
        YamlPlace at = string.IsNullOrEmpty(found.Place.File) ? Place : found.Place;
        return ImportException.At(at.ToString(), $"'{OneLine.Value(key)}' must be {expected}, found {found.Kind}.");
    }
}
