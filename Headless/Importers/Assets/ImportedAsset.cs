using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>The objects of one imported file by file id. It is known before it is filled, so that assets may refer to each other in a circle.</summary>
public sealed class ImportedAsset(string assetPath, string guid)
{
    private readonly Dictionary<long, Object> objects = [];
    private readonly HashSet<long> leftOut = [];
    private Object? main;
    private Action? rest;

    public string AssetPath { get; } = assetPath;
    public string Guid { get; } = guid;

    public Object? Main
    {
        get
        {
            if (main is null) Complete();
            return main;
        }
    }

    public IReadOnlyDictionary<long, Object> Objects
    {
        get
        {
            Complete();
            return objects;
        }
    }

    public void Add(long fileId, Object asset)
    {
        asset.IsPersistent = true;
        objects[fileId] = asset;
    }

    public void AddMain(long fileId, Object asset)
    {
        Add(fileId, asset);
        main = asset;
    }

    /// <summary>The file has an object that is not made here; whoever left it out has said so.</summary>
    public void LeaveOut(long fileId) => leftOut.Add(fileId);

    public bool IsLeftOut(long fileId) => leftOut.Contains(fileId);

    /// <summary>Puts off the part that few ask for: a model's meshes are used far more often than its prefab.</summary>
    public void AddLater(Action importRest) => rest = importRest;

    public Object? Find(long fileId)
    {
        if (!objects.ContainsKey(fileId)) Complete();
        return objects.GetValueOrDefault(fileId);
    }

    internal bool Contains(Object asset) => objects.Values.Any(o => ReferenceEquals(o, asset));

    private void Complete()
    {
        Action? todo = rest;
        rest = null;
        todo?.Invoke();
    }
}
