using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>A reflection probe whose box a camera sees.</summary>
public record struct VisibleReflectionProbe
{
    private readonly int instance;

    internal VisibleReflectionProbe(ReflectionProbe probe)
        : this()
    {
        instance = probe.GetInstanceID();
        bounds = probe.bounds;
        localToWorldMatrix = Matrix4x4.TRS(probe.transform.position, Quaternion.identity, Vector3.one);
        hdrData = probe.textureHDRDecodeValues;
        center = probe.center;
        blendDistance = probe.blendDistance;
        importance = probe.importance;
        isBoxProjection = probe.boxProjection;
    }

    public readonly Texture? texture => reflectionProbe.texture;
    public readonly ReflectionProbe reflectionProbe => (ReflectionProbe)ObjectRegistry.Find(instance)!;
    public Bounds bounds { get; set; }
    public Matrix4x4 localToWorldMatrix { get; set; }
    public Vector4 hdrData { get; set; }
    public Vector3 center { get; set; }
    public float blendDistance { get; set; }
    public int importance { get; set; }
    public bool isBoxProjection { get; set; }
}
