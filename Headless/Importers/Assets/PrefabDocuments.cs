using Headless.Importers.Models;
using Headless.Importers.Project;
using Headless.Importers.Yaml;

namespace Headless.Importers.Assets;

/// <summary>The documents of prefabs and models; each call gives a copy that overrides may change.</summary>
internal sealed class PrefabDocuments(ProjectIndex index)
{
    private readonly Dictionary<string, IReadOnlyList<UnityDocument>> known = [];

    public (string AssetPath, IReadOnlyList<UnityDocument> Documents) Read(string guid, string where)
    {
        if (index.PathOf(guid) is not { } path) throw new ImportException($"{where}: the prefab with GUID {guid} is missing from the project. Restore the prefab with its .meta, or delete the instance in the Editor.");
        if (!known.TryGetValue(guid, out IReadOnlyList<UnityDocument>? documents)) known[guid] = documents = Load(path, guid, where);
        return (path, [.. documents.Select(d => d with { Body = (YamlMap)d.Body.Clone() })]);
    }

    private List<UnityDocument> Load(string path, string guid, string where) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".prefab" => UnityYaml.ReadDocuments(index.FileOf(path)),
        ".obj" => ModelPrefab.Documents(Path.GetFileNameWithoutExtension(path), guid, ObjFile.Read(index.FileOf(path)).Groups.Select(g => g.Name)),
        var other => throw new ImportException($"{where}: '{path}' is used as a prefab, but {other} files are not imported here; .prefab and .obj are."),
    };
}
