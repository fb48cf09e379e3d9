using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>Replaces the prefab instances of a file by the prefab's own objects with the overrides applied, nested ones and variants included.</summary>
/// <param name="readPrefab">Documents of the prefab or model with this GUID; the objects may be changed.</param>
/// <param name="report">Takes a line for each override that cannot be applied.</param>
public sealed class PrefabExpander(Func<string, string, (string AssetPath, IReadOnlyList<UnityDocument> Documents)> readPrefab, Action<string> report)
{
    private readonly Stack<string> open = new();

    public SourceFile Expand(string assetPath, IReadOnlyList<UnityDocument> documents)
    {
        if (open.Contains(assetPath)) throw new ImportException($"Prefab '{assetPath}' contains itself ({string.Join(" > ", open.Reverse())} > {assetPath}).");
        open.Push(assetPath);
        try
        {
            return ExpandDocuments(assetPath, documents);
        }
        finally
        {
            open.Pop();
        }
    }

    private SourceFile ExpandDocuments(string assetPath, IReadOnlyList<UnityDocument> documents)
    {
        var file = new SourceFile(new SourceScope(assetPath));
        foreach (UnityDocument d in documents)
        {
            if (d.Stripped || d.ClassId == ClassIds.PrefabInstance) continue;
            var added = new SourceObject(d.ClassId, d.ClassName, d.FileId, d.Body, file.Scope);
            file.Objects.Add(added);
            file.Scope.Add(d.FileId, added);
        }
        ILookup<long, UnityDocument> stripped = documents.Where(d => d.Stripped)
            .ToLookup(d => FileReference.Read(d.Body["m_PrefabInstance"], file.Scope).FileId);
        foreach (UnityDocument d in documents)
            if (d.ClassId == ClassIds.PrefabInstance && !d.Stripped) ExpandInstance(file, d, stripped[d.FileId]);
        return file;
    }

    private void ExpandInstance(SourceFile file, UnityDocument instance, IEnumerable<UnityDocument> stripped)
    {
        FileReference source = FileReference.Read(instance.Body["m_SourcePrefab"], file.Scope);
        var (path, documents) = readPrefab(source.Guid, $"{file.Scope.AssetPath}: PrefabInstance {instance.FileId}");
        SourceFile inner = Expand(path, documents);
        YamlMap modification = instance.Body.Map("m_Modification") ?? new YamlMap();
        foreach (YamlNode item in modification.List("m_Modifications"))
            if (item is YamlMap change) Apply(change, inner, file.Scope);
        Remove(inner, modification, file.Scope);

        SourceObject? root = inner.RootTransform;
        FileReference parent = FileReference.Read(modification["m_TransformParent"], file.Scope);
        if (root is not null)
        {
            file.Scope.Add(instance.FileId, root);
            if (!parent.IsNull && modification["m_TransformParent"] is YamlMap node) root.Body.Set("m_Father", new ScopedReference(node, file.Scope));
        }
        foreach (UnityDocument placeholder in stripped)
        {
            long id = FileReference.Read(placeholder.Body["m_CorrespondingSourceObject"], file.Scope).FileId;
            if (inner.Scope.Find(id) is { } target) file.Scope.Add(placeholder.FileId, target);
        }
        // Seen from outside, an object of an instance has the id (instance id xor its own id) without the sign bit.
        foreach (var (id, target) in inner.Scope.Objects) file.Scope.AddDerived((instance.FileId ^ id) & long.MaxValue, target);
        file.Objects.AddRange(inner.Objects);
    }

    private void Apply(YamlMap change, SourceFile inner, SourceScope outer)
    {
        string path = change.Text("propertyPath");
        SourceObject? target = inner.Scope.Find(FileReference.Read(change["target"], outer).FileId);
        // Overrides of objects since removed from the prefab stay in files; the Editor ignores them too.
        if (target is null || path.Length == 0) return;
        bool isReference = change["objectReference"] is YamlMap r && (r.Long("fileID") != 0 || change.Text("value").Length == 0 && IsReferenceAt(target, path));
        YamlNode value = isReference ? new ScopedReference((YamlMap)change["objectReference"]!, outer) : new YamlScalar(change.Text("value"));
        try
        {
            PropertyPath.Set(target.Body, path, value);
        }
        catch (FormatException e)
        {
            report($"{outer.AssetPath}: {e.Message}");
        }
    }

    /// <summary>An override to null is written as an empty value with {fileID: 0}: it is a reference when the prefab has one there or the path is not a known text.</summary>
    private static bool IsReferenceAt(SourceObject target, string path)
    {
        YamlNode? node = target.Body;
        foreach (string part in path.Split('.'))
        {
            if (node is YamlList list && part.StartsWith("data[", StringComparison.Ordinal))
                node = int.TryParse(part[5..^1], out int i) && i < list.Items.Count ? list.Items[i] : null;
            else if (part != "Array") node = (node as YamlMap)?[part];
        }
        return FileReference.Is(node);
    }

    private static void Remove(SourceFile inner, YamlMap modification, SourceScope outer)
    {
        var removed = new HashSet<SourceObject>();
        foreach (YamlNode item in modification.List("m_RemovedComponents").Concat(modification.List("m_RemovedGameObjects")))
            if (inner.Scope.Find(FileReference.Read(item, outer).FileId) is { } target) RemoveTree(target, inner, removed);
        inner.Objects.RemoveAll(removed.Contains);
    }

    private static void RemoveTree(SourceObject target, SourceFile inner, HashSet<SourceObject> removed)
    {
        if (!removed.Add(target)) return;
        string owner = target.ClassId == ClassIds.GameObject ? "m_GameObject" : target.ClassId is ClassIds.Transform or ClassIds.RectTransform ? "m_Father" : "";
        if (owner.Length == 0) return;
        foreach (SourceObject other in inner.Objects)
        {
            FileReference reference = FileReference.Read(other.Body[owner], other.Scope);
            if (reference.IsNull || reference.Scope.Find(reference.FileId) != target) continue;
            RemoveTree(other, inner, removed);
            if (owner != "m_Father") continue;
            FileReference body = FileReference.Read(other.Body["m_GameObject"], other.Scope);
            if (body.Scope.Find(body.FileId) is { } gameObject) RemoveTree(gameObject, inner, removed);
        }
    }
}
