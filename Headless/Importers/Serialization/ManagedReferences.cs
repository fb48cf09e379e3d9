using System.Runtime.CompilerServices;
using Headless.Files;
using Headless.Importers.Yaml;

namespace Headless.Importers.Serialization;

/// <summary>The <c>references:</c> block at the end of an object: instances behind [SerializeReference] fields by <c>rid</c>.</summary>
internal sealed class ManagedReferences
{
    public const long Null = -2;
    public const string Key = "references";
    private readonly Dictionary<long, object> instances = [];
    private readonly Dictionary<long, YamlMap> data = [];

    private ManagedReferences() { }

    public IEnumerable<(object Instance, YamlMap Data)> Filled => instances.Select(i => (i.Value, data[i.Key]));

    /// <summary>A script may have a field called <c>references</c> of its own.</summary>
    public static bool IsTable(YamlNode? node) => node is YamlMap map && map.Has("RefIds");

    public object? Find(long rid) => instances.GetValueOrDefault(rid);

    public static ManagedReferences Read(YamlMap body, Func<string, System.Reflection.Assembly?> assemblies, string where, Action<string> report)
    {
        var table = new ManagedReferences();
        if (!IsTable(body[Key])) return table;
        foreach (YamlMap entry in ((YamlMap)body[Key]!).Maps("RefIds"))
        {
            if (entry.Long("rid") == Null) continue;
            YamlMap type = entry.Map("type") ?? new YamlMap();
            string name = type.Text("class").Replace('/', '+'), space = type.Text("ns"), assembly = type.Text("asm");
            if (Find(assemblies(assembly), space.Length > 0 ? $"{space}.{name}" : name) is not { } found)
            {
                report($"{where}: {OneLine.Value($"{space}.{name}")} of a [SerializeReference] field is no serialisable class of the assembly '{OneLine.Value(assembly)}'; the field stays null.");
                continue;
            }
            table.instances[entry.Long("rid")] = Create(found);
            table.data[entry.Long("rid")] = entry.Map("data") ?? new YamlMap();
        }
        return table;
    }

    /// <summary>The class by its full name; null where there is none that Unity would make an instance of.</summary>
    private static Type? Find(System.Reflection.Assembly? assembly, string name)
    {
        // Commas, brackets and the like are syntax of reflection, not parts of a class's name.
        if (assembly is null || name.Length == 0 || !name.All(c => char.IsLetterOrDigit(c) || c is '_' or '.' or '+' or '`')) return null;
        return assembly.GetType(name) is { IsAbstract: false, ContainsGenericParameters: false } type
            && !typeof(UnityEngine.Object).IsAssignableFrom(type) && type.IsDefined(typeof(SerializableAttribute), false)
                ? type
                : null;
    }

    internal static object Create(Type type) =>
        type.IsValueType || type.GetConstructor(System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.Public | System.Reflection.BindingFlags.NonPublic, Type.EmptyTypes) is not null
            ? Activator.CreateInstance(type, nonPublic: true)!
            : RuntimeHelpers.GetUninitializedObject(type);
}
