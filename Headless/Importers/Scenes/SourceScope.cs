namespace Headless.Importers.Scenes;

/// <summary>The objects that a plain <c>{fileID: N}</c> can mean: those of one file, or of one instance of a prefab.</summary>
public sealed class SourceScope(string assetPath)
{
    private readonly Dictionary<long, SourceObject> objects = [];

    public string AssetPath { get; } = assetPath;
    public IReadOnlyDictionary<long, SourceObject> Objects => objects;

    public void Add(long fileId, SourceObject target) => objects[fileId] = target;

    /// <summary>Does not replace: an id written in the file wins over a derived one.</summary>
    public void AddDerived(long fileId, SourceObject target) => objects.TryAdd(fileId, target);

    public SourceObject? Find(long fileId) => objects.GetValueOrDefault(fileId);
}
