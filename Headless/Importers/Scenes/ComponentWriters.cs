using UnityEngine;
using Headless.Importers.Serialization;
using Object = UnityEngine.Object;

namespace Headless.Importers.Scenes;

/// <summary>Class id and fields of engine components, as <see cref="ComponentReaders"/> reads them.</summary>
internal static class ComponentWriters
{
    /// <exception cref="NotSupportedException">The component is of a kind that is not written here.</exception>
    public static (int ClassId, IEnumerable<string> Fields) Of(Component component, Func<Object?, string> reference) => component switch
    {
        MeshFilter filter => (ClassIds.MeshFilter, [$"m_Mesh: {reference(filter.sharedMesh)}"]),
        MeshRenderer renderer => (ClassIds.MeshRenderer, RendererFields(renderer, reference)),
        Camera camera => (ClassIds.Camera, CameraFields(camera, reference)),
        Light light => (ClassIds.Light, LightFields(light, reference)),
        BoxCollider box => (ClassIds.BoxCollider, [.. ColliderFields(box), $"m_Size: {YamlText.Of(box.size)}", $"m_Center: {YamlText.Of(box.center)}"]),
        SphereCollider sphere => (ClassIds.SphereCollider, [.. ColliderFields(sphere), $"m_Radius: {YamlText.Of(sphere.radius)}", $"m_Center: {YamlText.Of(sphere.center)}"]),
        CapsuleCollider capsule => (ClassIds.CapsuleCollider, [.. ColliderFields(capsule), $"m_Radius: {YamlText.Of(capsule.radius)}",
            $"m_Height: {YamlText.Of(capsule.height)}", $"m_Direction: {capsule.direction}", $"m_Center: {YamlText.Of(capsule.center)}"]),
        MeshCollider mesh => (ClassIds.MeshCollider, [.. ColliderFields(mesh), $"m_Convex: {Flag(mesh.convex)}", $"m_Mesh: {reference(mesh.sharedMesh)}"]),
        _ => throw new NotSupportedException($"'{component.name}' has a {component.GetType().Name}, which cannot be saved here."),
    };

    private static IEnumerable<string> ColliderFields(Collider collider) => [$"m_IsTrigger: {Flag(collider.isTrigger)}", $"m_Enabled: {Flag(collider.enabled)}"];

    private static IEnumerable<string> RendererFields(MeshRenderer renderer, Func<Object?, string> reference)
    {
        yield return $"m_Enabled: {Flag(renderer.enabled)}";
        yield return $"m_CastShadows: {(int)renderer.shadowCastingMode}";
        yield return $"m_ReceiveShadows: {Flag(renderer.receiveShadows)}";
        yield return $"m_ReflectionProbeUsage: {(int)renderer.reflectionProbeUsage}";
        yield return $"m_RenderingLayerMask: {renderer.renderingLayerMask}";
        Material[] materials = renderer.sharedMaterials;
        yield return materials.Length == 0 ? "m_Materials: []" : "m_Materials:";
        foreach (Material material in materials) yield return $"- {reference(material)}";
        yield return $"m_SortingOrder: {renderer.sortingOrder}";
    }

    private static IEnumerable<string> CameraFields(Camera camera, Func<Object?, string> reference) =>
    [
        $"m_Enabled: {Flag(camera.enabled)}",
        "serializedVersion: 2",
        $"m_ClearFlags: {(int)camera.clearFlags}",
        $"m_BackGroundColor: {YamlText.Of(camera.backgroundColor)}",
        "m_NormalizedViewPortRect:",
        "  serializedVersion: 2",
        $"  x: {YamlText.Of(camera.rect.x)}",
        $"  y: {YamlText.Of(camera.rect.y)}",
        $"  width: {YamlText.Of(camera.rect.width)}",
        $"  height: {YamlText.Of(camera.rect.height)}",
        $"near clip plane: {YamlText.Of(camera.nearClipPlane)}",
        $"far clip plane: {YamlText.Of(camera.farClipPlane)}",
        $"field of view: {YamlText.Of(camera.fieldOfView)}",
        $"orthographic: {Flag(camera.orthographic)}",
        $"orthographic size: {YamlText.Of(camera.orthographicSize)}",
        $"m_Depth: {YamlText.Of(camera.depth)}",
        "m_CullingMask:",
        "  serializedVersion: 2",
        YamlText.Invariant($"  m_Bits: {(uint)camera.cullingMask}"),
        $"m_TargetTexture: {reference(camera.targetTexture)}",
        $"m_HDR: {Flag(camera.allowHDR)}",
        $"m_AllowMSAA: {Flag(camera.allowMSAA)}",
    ];

    private static IEnumerable<string> LightFields(Light light, Func<Object?, string> reference) =>
    [
        $"m_Enabled: {Flag(light.enabled)}",
        "serializedVersion: 10",
        $"m_Type: {(int)light.type}",
        $"m_Color: {YamlText.Of(light.color)}",
        $"m_Intensity: {YamlText.Of(light.intensity)}",
        $"m_Range: {YamlText.Of(light.range)}",
        $"m_SpotAngle: {YamlText.Of(light.spotAngle)}",
        "m_Shadows:",
        $"  m_Type: {(int)light.shadows}",
        $"  m_Strength: {YamlText.Of(light.shadowStrength)}",
        $"  m_Bias: {YamlText.Of(light.shadowBias)}",
        $"  m_NormalBias: {YamlText.Of(light.shadowNormalBias)}",
        $"  m_NearPlane: {YamlText.Of(light.shadowNearPlane)}",
        $"m_Cookie: {reference(light.cookie)}",
        $"m_RenderMode: {(int)light.renderMode}",
        "m_CullingMask:",
        "  serializedVersion: 2",
        YamlText.Invariant($"  m_Bits: {(uint)light.cullingMask}"),
        $"m_Lightmapping: {(int)light.lightmapBakeType}",
    ];

    private static int Flag(bool value) => value ? 1 : 0;
}
