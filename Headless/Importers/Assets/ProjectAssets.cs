using Headless.Files;
using Headless.Importers.Project;
using Headless.Importers.Scenes;
using Headless.Importers.Serialization;
using Headless.Shaders;
using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>The assets of a project, imported when they are first asked for.</summary>
public sealed class ProjectAssets : IReferenceResolver
{
    private readonly Dictionary<string, ImportedAsset> imported = [];
    private readonly Dictionary<string, IAssetImporter> importers;
    private readonly HashSet<string> reported = [];
    private readonly Action<string> write;
    private readonly IncludeResolver includes;

    /// <param name="scripts">Finds a loaded script assembly by its name, without extension.</param>
    /// <param name="report">Takes what is wrong with the project's files but does not end the run, each line once.</param>
    public ProjectAssets(ProjectIndex index, Func<string, System.Reflection.Assembly?> scripts, IncludeResolver includes, Action<string> report)
    {
        Index = index;
        write = report;
        this.includes = includes;
        Scripts = new ScriptCatalog(index, scripts, Report);
        ScriptReader = new ScriptReader(this, scripts, Report);
        Expander = new PrefabExpander(new PrefabDocuments(index).Read, Report);
        var native = new NativeImporter();
        var text = new TextImporter();
        var image = new ImageImporter();
        importers = new(StringComparer.OrdinalIgnoreCase)
        {
            [".prefab"] = new PrefabImporter(),
            [".mat"] = native, [".asset"] = native, [".renderTexture"] = native,
            [".obj"] = new ObjImporter(),
            [".shader"] = new ShaderImporter(includes), [".compute"] = new ComputeImporter(includes),
            [".png"] = image, [".jpg"] = image, [".jpeg"] = image,
            [".txt"] = text, [".json"] = text, [".csv"] = text, [".bytes"] = text, [".xml"] = text, [".yaml"] = text, [".md"] = text, [".html"] = text,
        };
    }

    /// <summary>The asset that is imported now, for a line of progress; null between imports.</summary>
    public static string? Importing { get; private set; }

    public ProjectIndex Index { get; }
    internal ScriptCatalog Scripts { get; }
    internal ScriptReader ScriptReader { get; }
    internal PrefabExpander Expander { get; }

    /// <summary>Main object of the asset at this path; null when it has none (folders, scripts, scenes).</summary>
    public Object? LoadMain(string assetPath) => Import(assetPath)?.Main;

    public IEnumerable<Object> LoadAll(string assetPath) => Import(assetPath)?.Objects.Values ?? Enumerable.Empty<Object>();

    /// <summary>File id and GUID of an object of an imported file; null for an object that is in none.</summary>
    public (long FileId, string Guid)? ReferenceTo(Object asset)
    {
        if (imported.Values.FirstOrDefault(i => i.Contains(asset)) is not { } file) return null;
        return (file.Objects.First(o => ReferenceEquals(o.Value, asset)).Key, file.Guid);
    }

    public string? PathOf(Object asset) => imported.Values.FirstOrDefault(i => i.Contains(asset))?.AssetPath;

    /// <summary>A shader of the project by the name in its source; reads each .shader until it is found, as Shader.Find does in the Editor.</summary>
    internal UnityEngine.Shader? FindShader(string name)
    {
        foreach (string path in Index.AssetPaths)
            if (path.EndsWith(".shader", StringComparison.OrdinalIgnoreCase)
                && BoundedText.ReadAll(Index.FileOf(path)).Contains($"\"{name}\"", StringComparison.Ordinal)
                && LoadMain(path) is UnityEngine.Shader shader && shader.name == name) return shader;
        return null;
    }

    public Object? Resolve(FileReference reference, Type expected, string where)
    {
        if (reference.IsNull) return null;
        Object? found;
        if (reference.Guid.Length == 0)
        {
            SourceObject? source = reference.Scope.Find(reference.FileId);
            if (source is null) Report($"{where}: fileID {reference.FileId} is not in {reference.Scope.AssetPath}; the reference is null.");
            found = source?.Instance;
        }
        else
        {
            found = BuiltinResources.IsBuiltin(reference.Guid) ? BuiltinResources.Find(reference, where, Report) : FindAsset(reference, where);
        }
        if (found is null || expected.IsInstanceOfType(found)) return found;
        // A field of a component type may be given by its GameObject and vice versa: Unity shows a type mismatch.
        Report($"{where}: {reference} is a {found.GetType().Name}, not a {expected.Name}; the reference is null.");
        return null;
    }

    /// <summary>
    /// Reads compute shaders again whose file or includes have changed, as the Editor does when it gets the focus back:
    /// the objects stay, so that what refers to them has the new kernels.
    /// </summary>
    public void ReimportChangedComputeShaders()
    {
        foreach (ImportedAsset asset in imported.Values)
        {
            if (asset.AssetPath.EndsWith(".compute", StringComparison.OrdinalIgnoreCase) is false || asset.Main is not UnityEngine.ComputeShader shader) continue;
            ComputeSource now = ComputeSource.Parse(Index.FileOf(asset.AssetPath), includes);
            if (!now.HasSameText(shader.Program.Source)) shader.Reimport(now);
        }
    }

    internal void Report(string line)
    {
        if (reported.Add(line)) write(line);
    }

    internal ImportedAsset? Import(string assetPath)
    {
        if (Index.GuidOf(assetPath) is not { } guid)
            throw new ImportException(Index.MissingMetas.Contains(assetPath)
                ? $"'{assetPath}' has no .meta file: open the project in the Editor once, so that it gets one."
                : $"'{assetPath}' is not an asset of this project.");
        if (imported.TryGetValue(guid, out ImportedAsset? known)) return known;
        if (!importers.TryGetValue(Path.GetExtension(assetPath), out IAssetImporter? importer)) return null;
        string file = Index.FileOf(assetPath);
        var result = new ImportedAsset(assetPath, guid);
        imported[guid] = result;
        string? outer = Importing;
        Importing = assetPath;
        try
        {
            importer.Import(new AssetFile(this, assetPath, file, MetaFile.Read(file + ".meta"), result));
        }
        catch (Exception e)
        {
            imported.Remove(guid);
            if (e is BadFileException or ShaderCompileException) throw;
            throw new ImportException($"{assetPath}: cannot be imported: {e.Message} Restore the file from version control, or save it again in the program that made it.", e);
        }
        finally
        {
            Importing = outer;
        }
        return result;
    }

    private Object? FindAsset(FileReference reference, string where)
    {
        if (Index.PathOf(reference.Guid) is not { } path)
        {
            Report($"{where}: no asset has the GUID {reference.Guid}; the reference is null.");
            return null;
        }
        if (Import(path) is not { } asset)
        {
            Report($"{where}: files like '{path}' are not imported here; the reference is null.");
            return null;
        }
        if (asset.Find(reference.FileId) is { } found) return found;
        if (reference.FileId == PrefabImporter.RootId) return asset.Main;
        if (asset.IsLeftOut(reference.FileId)) return null;
        Report($"{where}: '{path}' has no object with fileID {reference.FileId}; the reference is null.");
        return null;
    }
}
