using Headless.Importers.Scenes;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Importers.Assets;

/// <summary>What the Editor has built in, by file id: primitive meshes in <c>...e000...</c>, materials and shaders in <c>...f000...</c>.</summary>
internal static class BuiltinResources
{
    private const string DefaultResources = "0000000000000000e000000000000000";
    private const string ExtraResources = "0000000000000000f000000000000000";

    private static readonly Dictionary<long, string> meshes = new()
    {
        [10202] = "Cube.fbx", [10206] = "Cylinder.fbx", [10207] = "Sphere.fbx", [10208] = "Capsule.fbx", [10209] = "Plane.fbx", [10210] = "Quad.fbx",
    };

    private static readonly Dictionary<long, string> shaders = new()
    {
        [7] = "Legacy Shaders/Diffuse", [46] = "Standard", [45] = "Standard (Specular setup)", [47] = "Standard (Specular setup)",
        [10750] = "Unlit/Transparent", [10752] = "Unlit/Texture", [10755] = "Unlit/Color", [10753] = "Sprites/Default", [106] = "Skybox/Procedural",
    };

    private static readonly Dictionary<long, string> materials = new() { [10303] = "Default-Material.mat", [10304] = "Default-Skybox.mat" };

    public static bool IsBuiltin(string guid) => guid is DefaultResources or ExtraResources;

    /// <summary>The reference to an object that is built in, as files have it; null for other objects.</summary>
    public static string? ReferenceTo(Object item)
    {
        foreach (var (id, name) in meshes)
            if (ReferenceEquals(Resources.GetBuiltinResource(typeof(Mesh), name), item)) return $"{{fileID: {id}, guid: {DefaultResources}, type: 0}}";
        foreach (var (id, name) in materials)
            if (ReferenceEquals(Resources.GetBuiltinResource(typeof(Material), name), item)) return $"{{fileID: {id}, guid: {ExtraResources}, type: 0}}";
        return null;
    }

    public static Object? Find(FileReference reference, string where, Action<string> report)
    {
        Object? found = null;
        if (reference.Guid == DefaultResources && meshes.TryGetValue(reference.FileId, out string? mesh)) found = Resources.GetBuiltinResource(typeof(Mesh), mesh);
        else if (shaders.TryGetValue(reference.FileId, out string? shader)) found = Shader.Find(shader);
        else if (materials.TryGetValue(reference.FileId, out string? material)) found = Resources.GetBuiltinResource(typeof(Material), material);
        if (found == null) report($"{where}: the Editor's built-in object {reference} has no stand-in; the reference is null.");
        return found;
    }
}
