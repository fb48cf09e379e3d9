using Headless.Importers.Scenes;
using Headless.Importers.Yaml;

namespace Headless.Importers.Assets;

/// <summary>A prefab asset: its GameObjects belong to no scene and get no messages until they are instantiated.</summary>
internal sealed class PrefabImporter : IAssetImporter
{
    /// <summary>Stands for the root in references to a whole prefab.</summary>
    public const long RootId = 100100000;

    public void Import(AssetFile file) => Build(file, UnityYaml.ReadDocuments(file.File), 0);

    /// <param name="rootTransform">File id of the root's transform; 0 finds the one without a parent.</param>
    internal static void Build(AssetFile file, IReadOnlyList<UnityDocument> documents, long rootTransform)
    {
        var builder = new ObjectBuilder(file.Project);
        SourceFile source = file.Project.Expander.Expand(file.AssetPath, documents);
        builder.CreateHierarchy(source, null);
        SourceObject root = (rootTransform != 0 ? source.Scope.Find(rootTransform) : source.RootTransform)
            ?? throw new ImportException($"{file.AssetPath}: the prefab has no transform without a parent.");
        foreach (var (id, item) in source.Scope.Objects)
            if (item.Instance is { } instance) file.Result.Add(id, instance);
        if (root.Instance is not UnityEngine.Transform transform) throw new ImportException($"{file.AssetPath}: the root's transform belongs to no GameObject.");
        transform.gameObject.name = file.Name;
        file.Result.AddMain(RootId, transform.gameObject);
        builder.FillAll(source);
    }
}
