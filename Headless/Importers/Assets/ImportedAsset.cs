using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>The objects of one imported file by file id. It is known before it is filled, so that assets may refer to each other in a circle.</summary>
public sealed class ImportedAsset(string assetPath, string guid)
{
    private readonly Dictionary<long, Object> objects = [];

    public string AssetPath { get; } = assetPath;
    public string Guid { get; } = guid;
    public Object? Main { get; private set; }
    public IReadOnlyDictionary<long, Object> Objects => objects;

    public void Add(long fileId, Object asset)
    {
        asset.IsPersistent = true;
        objects[fileId] = asset;
    }

    public void AddMain(long fileId, Object asset)
    {
        Add(fileId, asset);
        Main = asset;
    }
}
