namespace Headless.Importers.Scenes;

/// <summary>A scene, prefab or asset file with its prefab instances expanded, in file order.</summary>
public sealed class SourceFile(SourceScope scope)
{
    public SourceScope Scope { get; } = scope;
    public List<SourceObject> Objects { get; } = [];

    /// <summary>The transform without a parent of a prefab.</summary>
    public SourceObject? RootTransform => Objects.Find(o => o.ClassId is ClassIds.Transform or ClassIds.RectTransform && FileReference.Read(o.Body["m_Father"], o.Scope).IsNull);
}
