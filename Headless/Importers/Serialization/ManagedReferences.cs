using System.Runtime.CompilerServices;
using Headless.Importers.Yaml;

namespace Headless.Importers.Serialization;

/// <summary>The <c>references:</c> block at the end of an object: instances behind [SerializeReference] fields by <c>rid</c>.</summary>
internal sealed class ManagedReferences
{
    public const long Null = -2;
    private readonly Dictionary<long, object> instances = [];
    private readonly Dictionary<long, YamlMap> data = [];

    private ManagedReferences() { }

    public IEnumerable<(object Instance, YamlMap Data)> Filled => instances.Select(i => (i.Value, data[i.Key]));

    public object? Find(long rid) => instances.GetValueOrDefault(rid);

    public static ManagedReferences Read(YamlMap body, Func<string, System.Reflection.Assembly?> assemblies, string where, Action<string> report)
    {
        var table = new ManagedReferences();
        foreach (YamlNode item in body.Map("references")?.List("RefIds") ?? [])
        {
            if (item is not YamlMap entry || entry.Long("rid") == Null) continue;
            YamlMap type = entry.Map("type") ?? new YamlMap();
            string name = type.Text("class").Replace('/', '+'), space = type.Text("ns"), assembly = type.Text("asm");
            if (assemblies(assembly)?.GetType(space.Length > 0 ? $"{space}.{name}" : name) is not { } found)
            {
                report($"{where}: the class {space}.{name} of a [SerializeReference] field is not in the assembly '{assembly}'; the field stays null.");
                continue;
            }
            table.instances[entry.Long("rid")] = Create(found);
            table.data[entry.Long("rid")] = entry.Map("data") ?? new YamlMap();
        }
        return table;
    }

    internal static object Create(Type type) =>
        type.IsValueType || type.GetConstructor(System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.Public | System.Reflection.BindingFlags.NonPublic, Type.EmptyTypes) is not null
            ? Activator.CreateInstance(type, nonPublic: true)!
            : RuntimeHelpers.GetUninitializedObject(type);
}
