using Headless.Importers.Serialization;
using Headless.Importers.Yaml;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Importers.Scenes;

/// <summary>Typed access to the fields of an engine class's YAML, references resolved.</summary>
internal readonly record struct NativeFields(YamlMap Map, SourceScope Scope, IReferenceResolver References, string Owner)
{
    public bool Has(string key) => Map.Has(key);
    public float Float(string key, float absent = 0) => Finite(Map.Float(key, absent), key);
    public int Int(string key, int absent = 0) => Map.Int(key, absent);
    public long Long(string key, long absent = 0) => Map.Long(key, absent);
    public bool Bool(string key, bool absent = false) => Map.Bool(key, absent);
    public string Text(string key, string absent = "") => Map.Text(key, absent);
    public Vector3 Vector3(string key, Vector3 absent = default)
    {
        Vector3 value = Map.Map(key) is { } m ? ValueReaders.Vector3(m) : absent;
        Finite(value.x + value.y + value.z, key);
        return value;
    }

    public Color Color(string key, Color absent) => Map.Map(key) is { } m ? ValueReaders.Color(m) : absent;
    public Quaternion Quaternion(string key)
    {
        Quaternion value = ValueReaders.Quaternion(Map.Map(key));
        Finite(value.x + value.y + value.z + value.w, key);
        return value;
    }

    public int LayerBits(string key, int absent) => Map.Map(key) is { } m ? ValueReaders.Bits(m) : absent;
    public NativeFields Nested(string key) => this with { Map = Map.Map(key) ?? new YamlMap() };

    public T? Reference<T>(string key) where T : Object => Resolve<T>(Map[key], key);

    public List<T?> ReferenceList<T>(string key) where T : Object
    {
        var list = new List<T?>();
        foreach (YamlNode node in Map.List(key)) list.Add(Resolve<T>(node, key));
        return list;
    }

    public T? Resolve<T>(YamlNode? node, string key) where T : Object => (T?)References.Resolve(FileReference.Read(node, Scope), typeof(T), $"{Owner}, {key}");

    private float Finite(float value, string key) => float.IsFinite(value)
        ? value
        : throw ImportException.At((Map[key] ?? Map).Place.ToString(), $"{Owner}: '{key}' must be finite.");
}
