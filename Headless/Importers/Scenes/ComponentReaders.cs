using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Scenes;

/// <summary>Engine components by class id: their type and how their fields are read. A field that is missing takes the engine's default.</summary>
internal static class ComponentReaders
{
    public sealed record Reader(Type Type, Action<Component, NativeFields> Fill);

    private static readonly Dictionary<int, Reader> readers = new()
    {
        [ClassIds.MeshFilter] = Of<MeshFilter>((c, f) => c.sharedMesh = f.Reference<Mesh>("m_Mesh")),
        [ClassIds.MeshRenderer] = Of<MeshRenderer>(FillRenderer),
        [ClassIds.SkinnedMeshRenderer] = Of<SkinnedMeshRenderer>(FillSkin),
        [ClassIds.Camera] = Of<Camera>(FillCamera),
        [ClassIds.Light] = Of<Light>(FillLight),
        [ClassIds.ReflectionProbe] = Of<ReflectionProbe>(FillProbe),
        [ClassIds.Rigidbody] = Of<Rigidbody>(FillRigidbody),
        [ClassIds.BoxCollider] = Of<BoxCollider>((c, f) => (c.center, c.size) = (f.Vector3("m_Center"), f.Vector3("m_Size", Vector3.one))),
        [ClassIds.SphereCollider] = Of<SphereCollider>((c, f) => (c.center, c.radius) = (f.Vector3("m_Center"), f.Float("m_Radius", 0.5f))),
        [ClassIds.CapsuleCollider] = Of<CapsuleCollider>((c, f) =>
            (c.center, c.radius, c.height, c.direction) = (f.Vector3("m_Center"), f.Float("m_Radius", 0.5f), f.Float("m_Height", 2), f.Int("m_Direction", 1))),
        [ClassIds.CharacterController] = Of<CharacterController>((c, f) =>
            (c.center, c.radius, c.height) = (f.Vector3("m_Center"), f.Float("m_Radius", 0.5f), f.Float("m_Height", 2))),
        [ClassIds.WheelCollider] = Of<WheelCollider>((c, f) =>
            (c.center, c.radius, c.suspensionDistance) = (f.Vector3("m_Center"), f.Float("m_Radius", 0.5f), f.Float("m_SuspensionDistance", 0.3f))),
        [ClassIds.MeshCollider] = Of<MeshCollider>((c, f) => (c.convex, c.sharedMesh) = (f.Bool("m_Convex"), f.Reference<Mesh>("m_Mesh")!)),
    };

    /// <summary>Classes without a stand-in that change nothing here: they are left out without a word.</summary>
    private static readonly HashSet<int> silent = [ClassIds.AudioListener, 92, 124, ClassIds.OcclusionCullingSettings, ClassIds.NavMeshSettings, ClassIds.SceneRoots];

    public static Reader? Find(int classId) => readers.GetValueOrDefault(classId);

    public static bool IsSilent(int classId) => silent.Contains(classId);

    private static Reader Of<T>(Action<T, NativeFields> fill) where T : Component => new(typeof(T), (component, fields) =>
    {
        switch (component)
        {
            case Behaviour behaviour:
                behaviour.SetEnabledRaw(fields.Bool("m_Enabled", true));
                break;
            case Renderer renderer:
                renderer.enabled = fields.Bool("m_Enabled", true);
                break;
            case Collider collider:
                collider.isTrigger = fields.Bool("m_IsTrigger");
                collider.enabled = fields.Bool("m_Enabled", true);
                break;
        }
        fill((T)component, fields);
    });

    // Newer lines of Unity call drag damping.
    private static void FillRigidbody(Rigidbody body, NativeFields f)
    {
        body.mass = f.Float("m_Mass", 1);
        body.drag = f.Float("m_Drag", f.Float("m_LinearDamping", 0));
        body.angularDrag = f.Float("m_AngularDrag", f.Float("m_AngularDamping", 0.05f));
        body.useGravity = f.Bool("m_UseGravity", true);
        body.isKinematic = f.Bool("m_IsKinematic");
        body.interpolation = (RigidbodyInterpolation)f.Int("m_Interpolate");
        body.constraints = (RigidbodyConstraints)f.Int("m_Constraints");
    }

    private static void FillSkin(SkinnedMeshRenderer renderer, NativeFields f)
    {
        FillRenderer(renderer, f);
        renderer.sharedMesh = f.Reference<Mesh>("m_Mesh");
        renderer.bones = [.. f.ReferenceList<Transform>("m_Bones")!];
        renderer.rootBone = f.Reference<Transform>("m_RootBone");
        renderer.quality = (SkinQuality)f.Int("m_Quality");
        renderer.updateWhenOffscreen = f.Bool("m_UpdateWhenOffscreen");
    }

    private static void FillRenderer(Renderer renderer, NativeFields f)
    {
        renderer.shadowCastingMode = (ShadowCastingMode)f.Int("m_CastShadows", 1);
        renderer.receiveShadows = f.Bool("m_ReceiveShadows", true);
        renderer.reflectionProbeUsage = (ReflectionProbeUsage)f.Int("m_ReflectionProbeUsage", 1);
        renderer.sharedMaterials = [.. f.ReferenceList<Material>("m_Materials")!];
        renderer.sortingOrder = f.Int("m_SortingOrder");
        renderer.renderingLayerMask = unchecked((uint)f.Long("m_RenderingLayerMask", 1));
    }

    private static void FillCamera(Camera camera, NativeFields f)
    {
        camera.clearFlags = (CameraClearFlags)f.Int("m_ClearFlags", 1);
        camera.backgroundColor = f.Color("m_BackGroundColor", new Color(0.19215687f, 0.3019608f, 0.4745098f, 0));
        camera.nearClipPlane = f.Float("near clip plane", 0.3f);
        camera.farClipPlane = f.Float("far clip plane", 1000);
        camera.fieldOfView = f.Float("field of view", 60);
        camera.orthographic = f.Bool("orthographic");
        camera.orthographicSize = f.Float("orthographic size", 5);
        camera.depth = f.Float("m_Depth");
        camera.cullingMask = f.LayerBits("m_CullingMask", -1);
        camera.allowHDR = f.Bool("m_HDR", true);
        camera.allowMSAA = f.Bool("m_AllowMSAA", true);
        camera.targetTexture = f.Reference<RenderTexture>("m_TargetTexture");
        NativeFields rect = f.Nested("m_NormalizedViewPortRect");
        camera.rect = new Rect(rect.Float("x"), rect.Float("y"), rect.Float("width", 1), rect.Float("height", 1));
    }

    private static void FillLight(Light light, NativeFields f)
    {
        light.type = (LightType)f.Int("m_Type", 1);
        light.color = f.Color("m_Color", Color.white);
        light.intensity = f.Float("m_Intensity", 1);
        light.range = f.Float("m_Range", 10);
        light.spotAngle = f.Float("m_SpotAngle", 30);
        light.cullingMask = f.LayerBits("m_CullingMask", -1);
        light.renderMode = (LightRenderMode)f.Int("m_RenderMode");
        light.lightmapBakeType = (LightmapBakeType)f.Int("m_Lightmapping", (int)LightmapBakeType.Realtime);
        light.cookie = f.Reference<Texture>("m_Cookie");
        NativeFields shadows = f.Nested("m_Shadows");
        light.shadows = (LightShadows)shadows.Int("m_Type");
        light.shadowStrength = shadows.Float("m_Strength", 1);
        light.shadowBias = shadows.Float("m_Bias", 0.05f);
        light.shadowNormalBias = shadows.Float("m_NormalBias", 0.4f);
        light.shadowNearPlane = shadows.Float("m_NearPlane", 0.2f);
    }

    private static void FillProbe(ReflectionProbe probe, NativeFields f)
    {
        probe.mode = (ReflectionProbeMode)f.Int("m_Mode");
        probe.refreshMode = (ReflectionProbeRefreshMode)f.Int("m_RefreshMode");
        probe.timeSlicingMode = (ReflectionProbeTimeSlicingMode)f.Int("m_TimeSlicingMode");
        probe.clearFlags = (ReflectionProbeClearFlags)f.Int("m_ClearFlags", 1);
        probe.backgroundColor = f.Color("m_BackGroundColor", probe.backgroundColor);
        probe.cullingMask = f.LayerBits("m_CullingMask", -1);
        probe.resolution = f.Int("m_Resolution", 128);
        probe.hdr = f.Bool("m_HDR", true);
        probe.nearClipPlane = f.Float("m_NearClip", 0.3f);
        probe.farClipPlane = f.Float("m_FarClip", 1000);
        probe.shadowDistance = f.Float("m_ShadowDistance", 100);
        probe.renderDynamicObjects = f.Bool("m_RenderDynamicObjects");
        probe.center = f.Vector3("m_BoxOffset");
        probe.size = f.Vector3("m_BoxSize", new Vector3(10, 10, 10));
        probe.blendDistance = f.Float("m_BlendDistance", 1);
        probe.boxProjection = f.Bool("m_BoxProjection");
        probe.importance = f.Int("m_Importance", 1);
        probe.intensity = f.Float("m_IntensityMultiplier", 1);
        probe.customBakedTexture = f.Reference<Texture>("m_CustomBakedTexture");
    }
}
