using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>Replaces the prefab instances of a file by the prefab's own objects with the overrides applied, nested ones and variants included.</summary>
/// <param name="readPrefab">Documents of the prefab or model with this GUID; the objects may be changed.</param>
/// <param name="report">Takes a line for each override that cannot be applied.</param>
public sealed class PrefabExpander(Func<string, string, (string AssetPath, IReadOnlyList<UnityDocument> Documents)> readPrefab, Action<string> report)
{
    private const int DeepestNesting = 64;
    private readonly Stack<string> open = new();
    private ValueBudget budget = new("");

    public SourceFile Expand(string assetPath, IReadOnlyList<UnityDocument> documents)
    {
        if (open.Contains(assetPath)) throw new ImportException($"Prefab '{assetPath}' contains itself ({string.Join(" > ", open.Reverse())} > {assetPath}). Remove the inner instance.");
        if (open.Count >= DeepestNesting) throw new ImportException($"{open.Last()}: prefabs are nested more than {DeepestNesting} deep, down to '{assetPath}'. Unpack some of them.");
        if (open.Count == 0) budget = new ValueBudget(assetPath);
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
            var added = new SourceObject(d.ClassId, d.ClassName, d.FileId, d.Body, file.Scope, d.Line);
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
        budget.Take(documents.Sum(d => d.Body.Weight));
        SourceFile inner = Expand(path, documents);
        YamlMap modification = instance.Body.Map("m_Modification") ?? new YamlMap();
        foreach (YamlMap change in modification.Maps("m_Modifications")) Apply(change, inner, file.Scope);
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
        YamlMap? reference = change.Map("objectReference");
        bool isReference = reference is not null && (reference.Long("fileID") != 0 || change.Text("value").Length == 0 && IsReferenceAt(target, path));
        YamlNode value = isReference ? new ScopedReference(reference!, outer) : new YamlScalar(change.Text("value"), (change["value"] ?? change).Place);
        try
        {
            PropertyPath.Set(target.Body, path, value, budget);
        }
        catch (FormatException e)
        {
            report($"{change.Place}: {e.Message}");
        }
    }

    /// <summary>An override to null is written as an empty value with {fileID: 0}: it is a reference when the prefab has one there or the path is not a known text.</summary>
    private static bool IsReferenceAt(SourceObject target, string path)
    {
        YamlNode? node = target.Body;
        foreach (string part in path.Split('.'))
        {
            if (node is YamlList list && PropertyPath.IndexOf(part) is { } index)
                node = index < list.Items.Count ? list.Items[index] : null;
            else if (part != "Array") node = (node as YamlMap)?[part];
        }
        return FileReference.Is(node);
    }

    private static void Remove(SourceFile inner, YamlMap modification, SourceScope outer)
    {
        var waiting = new Stack<SourceObject>();
        foreach (YamlNode item in modification.List("m_RemovedComponents").Concat(modification.List("m_RemovedGameObjects")))
            if (inner.Scope.Find(FileReference.Read(item, outer).FileId) is { } target) waiting.Push(target);
        if (waiting.Count == 0) return;

        ILookup<SourceObject, SourceObject> dependents = inner.Objects.SelectMany(Dependences).ToLookup(d => d.On, d => d.Dependent);
        var removed = new HashSet<SourceObject>();
        while (waiting.TryPop(out SourceObject? next))
        {
            if (!removed.Add(next)) continue;
            foreach (SourceObject dependent in dependents[next]) waiting.Push(dependent);
        }
        inner.Objects.RemoveAll(removed.Contains);
    }

    /// <summary>A component goes with its GameObject, a child's GameObject with its parent's transform.</summary>
    private static IEnumerable<(SourceObject On, SourceObject Dependent)> Dependences(SourceObject item)
    {
        SourceObject? owner = Linked(item, "m_GameObject");
        if (owner is not null) yield return (owner, item);
        if (item.ClassId is not (ClassIds.Transform or ClassIds.RectTransform) || Linked(item, "m_Father") is not { } father) yield break;
        yield return (father, item);
        if (owner is not null) yield return (father, owner);
    }

    private static SourceObject? Linked(SourceObject item, string key)
    {
        FileReference reference = FileReference.Read(item.Body[key], item.Scope);
        return reference.IsNull ? null : reference.Scope.Find(reference.FileId);
    }
}
