using Headless.Engine;
using Headless.Importers.Scenes;
using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>The project behind UnityEditor.AssetDatabase and UnityEngine.Resources.</summary>
internal sealed class ProjectDatabase(ProjectAssets project) : IAssetDatabase
{
    private const string ResourcesFolder = "/Resources/";

    public Object? LoadMain(string path) => Exists(path) ? project.LoadMain(path) : null;

    public Object? Load(string path, Type type)
    {
        if (!Exists(path)) return null;
        return project.LoadMain(path) is { } main && type.IsInstanceOfType(main) ? main : project.LoadAll(path).FirstOrDefault(type.IsInstanceOfType);
    }

    public Object[] LoadAll(string path) => Exists(path) ? [.. project.LoadAll(path)] : [];

    public string GuidToPath(string guid) => project.Index.PathOf(guid) ?? "";

    public string PathToGuid(string path)
    {
        project.Index.MountSample(path);
        return project.Index.GuidOf(path) ?? "";
    }

    public string PathOf(Object asset) => project.PathOf(asset) ?? "";

    /// <summary>Words of the filter must be in the file's name; <c>t:Type</c> asks for the main object's type or, for scripts and scenes, MonoScript and Scene.</summary>
    public string[] Find(string filter, string[]? folders)
    {
        string[] words = filter.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        string[] types = [.. words.Where(w => w.StartsWith("t:", StringComparison.Ordinal)).Select(w => w[2..])];
        string[] names = [.. words.Where(w => !w.Contains(':'))];
        IEnumerable<string> paths = project.Index.AssetPaths.Where(p => folders is not { Length: > 0 } || folders.Any(f => p.StartsWith(f.TrimEnd('/') + "/", StringComparison.Ordinal)));
        return [.. paths
            .Where(p => names.All(n => Path.GetFileNameWithoutExtension(p).Contains(n, StringComparison.OrdinalIgnoreCase)))
            .Where(p => types.Length == 0 || types.Any(t => IsOfType(p, t)))
            .Select(p => project.Index.GuidOf(p)!)];
    }

    /// <summary>By the path below a Resources folder, without extension.</summary>
    public Object? LoadResource(string path, Type type) => LoadAllResources(path, type, exact: true).FirstOrDefault();

    public IEnumerable<Object> LoadAllResources(string path, Type type, bool exact)
    {
        foreach (string asset in project.Index.AssetPaths)
        {
            int at = asset.LastIndexOf(ResourcesFolder, StringComparison.Ordinal);
            if (at < 0) continue;
            string below = Path.ChangeExtension(asset[(at + ResourcesFolder.Length)..], null);
            bool matches = exact ? string.Equals(below, path, StringComparison.OrdinalIgnoreCase) : path.Length == 0 || below == path || below.StartsWith(path.TrimEnd('/') + "/", StringComparison.OrdinalIgnoreCase);
            if (matches && Load(asset, type) is { } found) yield return found;
        }
    }

    private bool Exists(string path)
    {
        project.Index.MountSample(path);
        return project.Index.GuidOf(path) is not null;
    }

    private bool IsOfType(string path, string type)
    {
        switch (Path.GetExtension(path))
        {
            case ".cs": return type is "Script" or "MonoScript";
            case ".unity": return type is "Scene" or "SceneAsset";
            case ".prefab": return type is "Prefab" or "GameObject";
        }
        for (Type? t = LoadMain(path)?.GetType(); t is not null; t = t.BaseType)
            if (t.Name == type || t.FullName == type) return true;
        return false;
    }
}
