using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>Files that Unity stores as they are: materials, ScriptableObjects and other single objects in YAML.</summary>
internal sealed class NativeImporter : IAssetImporter
{
    public void Import(AssetFile file)
    {
        List<UnityDocument> documents = UnityYaml.ReadDocuments(file.File);
        long mainId = file.Meta.Settings.Long("mainObjectFileID");
        if (documents.TrueForAll(d => d.FileId != mainId)) mainId = documents[0].FileId;

        var builder = new ObjectBuilder(file.Project);
        SourceFile source = file.Project.Expander.Expand(file.AssetPath, documents);
        foreach (SourceObject item in source.Objects)
        {
            if (builder.CreateAsset(item) is not { } created)
            {
                file.Result.LeaveOut(item.FileId);
                continue;
            }
            bool isMain = item.FileId == mainId;
            created.name = isMain ? file.Name : item.Name;
            if (isMain) file.Result.AddMain(item.FileId, created);
            else file.Result.Add(item.FileId, created);
        }
        foreach (SourceObject item in source.Objects) builder.Fill(item);
        foreach (Object item in file.Result.Objects.Values)
            if (item is UnityEngine.ScriptableObject script) script.SendAwake();
    }
}
