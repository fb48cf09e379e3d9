using Headless.Files;
using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>
/// <c>{fileID: N}</c> or <c>{fileID: N, guid: G, type: T}</c>. Without a GUID it is looked up in <paramref name="Scope"/>.
/// </summary>
public readonly record struct FileReference(long FileId, string Guid, SourceScope Scope)
{
    public bool IsNull => FileId == 0;

    public static bool Is(YamlNode? node) => node is ScopedReference || node is YamlMap map && map.Has("fileID");

    public static FileReference Read(YamlNode? node, SourceScope scope)
    {
        if (node is ScopedReference scoped) (node, scope) = (scoped.Reference, scoped.Scope);
        return node switch
        {
            YamlMap map => new FileReference(map.Long("fileID"), map.Text("guid"), scope),
            null or YamlScalar { IsEmpty: true } or YamlList { Items.Count: 0 } => new FileReference(0, "", scope),
            _ => throw ImportException.At(node.Place.ToString(), $"a reference {{fileID: ...}} was expected, found {node.Kind}."),
        };
    }

    public override string ToString() => Guid.Length > 0 ? $"{{fileID: {FileId}, guid: {OneLine.Value(Guid)}}}" : $"{{fileID: {FileId}}}";
}
