using Headless.Importers.Scenes;
using Headless.Importers.Yaml;

namespace Headless.Importers.Models;

/// <summary>
/// The prefab that a model file stands for: a root named after the file, one child a mesh with a filter and a renderer.
/// File ids follow <c>fileIdsGeneration: 2</c>.
/// </summary>
public static class ModelPrefab
{
    private const string DefaultMaterial = "0000000000000000f000000000000000";

    public static long RootGameObject { get; } = XxHash64.FileId("GameObject", "//RootNode/root");
    public static long RootTransform { get; } = XxHash64.FileId("Transform", "//RootNode/root/Transform");

    public static long MeshId(string name) => XxHash64.FileId("Mesh", name);

    public static List<UnityDocument> Documents(string modelName, string guid, IEnumerable<string> meshNames)
    {
        var documents = new List<UnityDocument>();
        var children = new YamlList();
        foreach (string name in meshNames)
        {
            string path = "//RootNode/root/" + name;
            long gameObject = XxHash64.FileId("GameObject", path), transform = XxHash64.FileId("Transform", path + "/Transform");
            long filter = XxHash64.FileId("MeshFilter", path + "/MeshFilter"), renderer = XxHash64.FileId("MeshRenderer", path + "/MeshRenderer");
            children.Items.Add(Reference(transform));
            documents.Add(GameObject(gameObject, name, [transform, filter, renderer]));
            documents.Add(Transform(transform, gameObject, RootTransform, new YamlList()));
            documents.Add(new UnityDocument(ClassIds.MeshFilter, filter, false, "MeshFilter",
                Map(("m_GameObject", Reference(gameObject)), ("m_Mesh", Reference(MeshId(name), guid))), 0));
            var materials = new YamlList();
            materials.Items.Add(Reference(10303, DefaultMaterial));
            documents.Add(new UnityDocument(ClassIds.MeshRenderer, renderer, false, "MeshRenderer",
                Map(("m_GameObject", Reference(gameObject)), ("m_Enabled", new YamlScalar("1")), ("m_Materials", materials)), 0));
        }
        documents.Insert(0, Transform(RootTransform, RootGameObject, 0, children));
        documents.Insert(0, GameObject(RootGameObject, modelName, [RootTransform]));
        return documents;
    }

    private static UnityDocument GameObject(long id, string name, IEnumerable<long> components)
    {
        var list = new YamlList();
        foreach (long component in components) list.Items.Add(Map(("component", Reference(component))));
        return new UnityDocument(ClassIds.GameObject, id, false, "GameObject",
            Map(("m_Component", list), ("m_Layer", new YamlScalar("0")), ("m_Name", new YamlScalar(name)), ("m_IsActive", new YamlScalar("1"))), 0);
    }

    private static UnityDocument Transform(long id, long gameObject, long father, YamlList children) =>
        new(ClassIds.Transform, id, false, "Transform", Map(("m_GameObject", Reference(gameObject)), ("m_Children", children), ("m_Father", Reference(father))), 0);

    private static YamlMap Reference(long fileId, string guid = "")
    {
        YamlMap map = Map(("fileID", new YamlScalar(fileId.ToString(System.Globalization.CultureInfo.InvariantCulture))));
        if (guid.Length > 0) map.Set("guid", new YamlScalar(guid));
        return map;
    }

    private static YamlMap Map(params (string Key, YamlNode Value)[] entries)
    {
        var map = new YamlMap();
        foreach (var (key, value) in entries) map.Set(key, value);
        return map;
    }
}
