using Headless.Engine;
using Headless.Files;
using Headless.Importers.Assets;
using Headless.Importers.Serialization;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Importers.Scenes;

/// <summary>
/// Turns described objects into engine objects in two steps: first all of them, then their fields, so that every
/// reference finds its target. Nothing gets a message here.
/// </summary>
internal sealed class ObjectBuilder(ProjectAssets project)
{
    /// <summary>GameObjects with their components and parents. <paramref name="scene"/> null makes a prefab asset.</summary>
    public void CreateHierarchy(SourceFile file, SceneData? scene)
    {
        foreach (SourceObject item in file.Objects) CheckOwner(item);
        ILookup<SourceObject, SourceObject> components = file.Objects.Where(o => o.ClassId != ClassIds.GameObject && Owner(o) is not null).ToLookup(o => Owner(o)!);
        foreach (SourceObject item in RootsFirst(file))
        {
            if (components[item].Where(IsTransform).Skip(1).FirstOrDefault() is { } second)
                throw ImportException.At(Place(second), $"{Describe(item)} has more than one Transform.");
            var gameObject = new GameObject(item.Name, scene, false) { IsPersistent = scene is null };
            item.Instance = gameObject;
            foreach (SourceObject component in InComponentOrder(item, components[item]))
            {
                component.Instance = Guard(component, () => CreateComponent(gameObject, component));
                if (component.Instance is { } created) created.IsPersistent = scene is null;
            }
        }
        LinkParents(file);
    }

    /// <summary>A single asset object: a material, a ScriptableObject; null when its class is not known, which is reported.</summary>
    public Object? CreateAsset(SourceObject item)
    {
        item.Instance = Guard(item, () => MakeAsset(item));
        return item.Instance;
    }

    private Object? MakeAsset(SourceObject item)
    {
        switch (item.ClassId)
        {
            case ClassIds.Material: return MaterialReader.Create(Fields(item));
            case ClassIds.RenderTexture: return RenderTextureReader.Create(Fields(item));
            case ClassIds.MonoBehaviour:
                return ScriptOf(item, typeof(ScriptableObject)) is { } script ? ScriptableObject.CreateRaw(script) : null;
            default:
                project.Report($"{item.Scope.AssetPath}: objects of the class {OneLine.Value(item.ClassName)} ({item.ClassId}) are not read here; it is left out.");
                return null;
        }
    }

    public void FillAll(SourceFile file)
    {
        foreach (SourceObject item in file.Objects) Fill(item);
    }

    public void Fill(SourceObject item)
    {
        Guard<Component?>(item, () =>
        {
            FillObject(item);
            return null;
        });
    }

    private void FillObject(SourceObject item)
    {
        NativeFields f = Fields(item);
        switch (item.Instance)
        {
            case null:
                break;
            case GameObject gameObject:
                gameObject.layer = f.Int("m_Layer") is >= 0 and < 32 and var layer
                    ? layer
                    : throw new ArgumentException($"layer {f.Int("m_Layer")} is not from 0 to 31.");
                gameObject.SetTagRaw(f.Text("m_TagString", "Untagged"));
                gameObject.isStatic = f.Long("m_StaticEditorFlags") != 0;
                gameObject.hideFlags = (HideFlags)f.Int("m_ObjectHideFlags");
                gameObject.SetActiveRaw(f.Bool("m_IsActive", true));
                break;
            case Transform:
                break;
            case Material material:
                MaterialReader.Fill(material, f);
                break;
            case MonoBehaviour script:
                script.SetEnabledRaw(f.Bool("m_Enabled", true));
                script.hideFlags = (HideFlags)f.Int("m_ObjectHideFlags");
                project.ScriptReader.Fill(script, item.Body, item.Scope, Describe(item));
                break;
            case ScriptableObject script:
                script.hideFlags = (HideFlags)f.Int("m_ObjectHideFlags");
                project.ScriptReader.Fill(script, item.Body, item.Scope, Describe(item));
                break;
            case Component component:
                ComponentReaders.Find(item.ClassId)!.Fill(component, f);
                break;
        }
    }

    private Component? CreateComponent(GameObject gameObject, SourceObject item)
    {
        switch (item.ClassId)
        {
            case ClassIds.Transform or ClassIds.RectTransform:
                return gameObject.TransformCore;
            case ClassIds.MonoBehaviour:
                return ScriptOf(item, typeof(MonoBehaviour)) is { } type ? gameObject.AddComponentRaw(type) : null;
        }
        if (ComponentReaders.Find(item.ClassId) is { } reader) return gameObject.AddComponentRaw(reader.Type);
        if (!ComponentReaders.IsSilent(item.ClassId))
            project.Report($"{item.Scope.AssetPath}: components of the class {OneLine.Value(item.ClassName)} ({item.ClassId}) have no stand-in; they are left out.");
        return null;
    }

    private Type? ScriptOf(SourceObject item, Type baseType)
    {
        FileReference script = FileReference.Read(item.Body["m_Script"], item.Scope);
        if (script.Guid.Length > 0) return project.Scripts.Find(script.Guid, baseType, Describe(item));
        project.Report($"{Describe(item)}: the script is missing; the component is left out.");
        return null;
    }

    private void LinkParents(SourceFile file)
    {
        HierarchyCheck.Require(file, Father, Place, item => Describe(Owner(item) ?? item));
        foreach (SourceObject item in file.Objects)
        {
            if (item.Instance is not Transform transform) continue;
            NativeFields f = Fields(item);
            transform.SetLocalRaw(f.Vector3("m_LocalPosition"), f.Quaternion("m_LocalRotation"), f.Vector3("m_LocalScale", Vector3.one));
            // Children that their parent lists come in its order; those of prefab instances may not be listed.
            foreach (Yaml.YamlNode node in item.Body.List("m_Children"))
            {
                FileReference child = FileReference.Read(node, item.Scope);
                if (child.Scope.Find(child.FileId) is { Instance: Transform below } source && Father(source) == item) below.Relink(transform);
            }
        }
        foreach (SourceObject item in file.Objects)
            if (item.Instance is Transform { ParentCore: null } transform && Father(item) is { Instance: Transform parent }) transform.Relink(parent);
    }

    /// <summary>GameObjects, the scene's roots first and in the order of SceneRoots (or of m_RootOrder in older files).</summary>
    private static IEnumerable<SourceObject> RootsFirst(SourceFile file)
    {
        var order = new Dictionary<SourceObject, int>();
        foreach (SourceObject roots in file.Objects.Where(o => o.ClassId == ClassIds.SceneRoots))
            foreach (Yaml.YamlNode node in roots.Body.List("m_Roots"))
            {
                FileReference root = FileReference.Read(node, roots.Scope);
                if (root.Scope.Find(root.FileId) is { } transform && Owner(transform) is { } owner) order.TryAdd(owner, order.Count);
            }
        foreach (SourceObject transform in file.Objects.Where(o => o.Body.Has("m_RootOrder") && Father(o) is null))
            if (Owner(transform) is { } owner) order.TryAdd(owner, transform.Body.Int("m_RootOrder"));
        return file.Objects.Where(o => o.ClassId == ClassIds.GameObject).OrderBy(o => order.GetValueOrDefault(o, int.MaxValue));
    }

    private static IEnumerable<SourceObject> InComponentOrder(SourceObject gameObject, IEnumerable<SourceObject> components)
    {
        var listed = new Dictionary<SourceObject, int>();
        foreach (Yaml.YamlNode node in gameObject.Body.List("m_Component"))
        {
            // Files of Unity 5.4 and older wrote "- 4: {fileID: N}".
            FileReference reference = FileReference.Read(node is Yaml.YamlMap { Count: > 0 } map ? map.Entries[0].Value : null, gameObject.Scope);
            if (reference.Scope.Find(reference.FileId) is { } component) listed.TryAdd(component, listed.Count);
        }
        return components.OrderBy(c => listed.GetValueOrDefault(c, int.MaxValue));
    }

    private static SourceObject? Owner(SourceObject item) => Linked(item, "m_GameObject");

    private static SourceObject? Father(SourceObject item) => Linked(item, "m_Father");

    private static SourceObject? Linked(SourceObject item, string key)
    {
        FileReference reference = FileReference.Read(item.Body[key], item.Scope);
        return reference.IsNull ? null : reference.Scope.Find(reference.FileId);
    }

    public NativeFields Fields(SourceObject item) => new(item.Body, item.Scope, project, Describe(item));

    /// <summary>Values of the right kind that an engine object refuses are faults of the file: a texture of 10^9 pixels, an enum without such a number.</summary>
    private static T Guard<T>(SourceObject item, Func<T> action)
    {
        try
        {
            return action();
        }
        catch (Exception e) when (e is not BadFileException)
        {
            throw ImportException.At(Place(item), $"{Describe(item)}: {e.Message}", inner: e);
        }
    }

    private void CheckOwner(SourceObject item)
    {
        if (item.ClassId == ClassIds.GameObject || !item.Body.Has("m_GameObject") || Owner(item) is { ClassId: ClassIds.GameObject }) return;
        if (!FileReference.Read(item.Body["m_GameObject"], item.Scope).IsNull)
            project.Report($"{Place(item)}: this {OneLine.Value(item.ClassName)} belongs to no GameObject of the file; it is left out.");
    }

    private static bool IsTransform(SourceObject item) => item.ClassId is ClassIds.Transform or ClassIds.RectTransform;

    private static string Place(SourceObject item) => item.Body.Place.Line > 0 ? item.Body.Place.ToString() : item.Scope.AssetPath;

    private static string Describe(SourceObject item)
    {
        string name = item.ClassId == ClassIds.GameObject || item.Name.Length > 0 ? item.Name : Owner(item)?.Name ?? "";
        string kind = item.Instance is { } instance ? instance.GetType().Name : OneLine.Value(item.ClassName);
        return name.Length > 0 ? $"{item.Scope.AssetPath}: {kind} of '{OneLine.Value(name)}'" : $"{item.Scope.AssetPath}: {kind} {item.FileId}";
    }
}
