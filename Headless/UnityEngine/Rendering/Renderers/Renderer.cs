using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class Renderer : Component
{
    private bool isEnabled = true;
    private Material?[] sharedList = [];
    private bool ownsMaterials;
    private Bounds? boundsOverride;
    private Bounds? localBoundsOverride;

    public bool enabled
    {
        get => isEnabled;
        set
        {
            isEnabled = value;
            RefreshActivation();
        }
    }

    public bool isVisible => IsAdded && !forceRenderingOff;
    public bool forceRenderingOff { get; set; }
    public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;
    public bool receiveShadows { get; set; } = true;
    public LightProbeUsage lightProbeUsage { get; set; } = LightProbeUsage.BlendProbes;
    public ReflectionProbeUsage reflectionProbeUsage { get; set; } = ReflectionProbeUsage.BlendProbes;
    public MotionVectorGenerationMode motionVectorGenerationMode { get; set; } = MotionVectorGenerationMode.Object;
    public uint renderingLayerMask { get; set; } = 1u;
    public int rendererPriority { get; set; }
    public int sortingLayerID { get; set; }
    public string sortingLayerName { get; set; } = "Default";
    public int sortingOrder { get; set; }
    public int lightmapIndex { get; set; } = -1;
    public Vector4 lightmapScaleOffset { get; set; } = new(1f, 1f, 0f, 0f);
    public Transform? probeAnchor { get; set; }
    public bool allowOcclusionWhenDynamic { get; set; } = true;
    public bool staticShadowCaster { get; set; }
    public bool isPartOfStaticBatch => false;
    public Matrix4x4 localToWorldMatrix => transform.localToWorldMatrix;
    public Matrix4x4 worldToLocalMatrix => transform.worldToLocalMatrix;

    public Bounds bounds
    {
        get => boundsOverride ?? BoundsTransform.ToWorld(localBounds, BoundsToWorld);
        set => boundsOverride = value;
    }

    public Bounds localBounds
    {
        get => localBoundsOverride ?? (MeshOfBounds is { } mesh ? mesh.bounds : default);
        set => localBoundsOverride = value;
    }

    internal override bool EnabledSelf => isEnabled;

    /// <summary>The mesh that is drawn; null draws nothing.</summary>
    internal virtual Mesh? MeshToDraw => null;

    internal virtual Mesh? MeshOfBounds => MeshToDraw;

    internal virtual Matrix4x4 BoundsToWorld => localToWorldMatrix;

    internal Material?[] Materials => sharedList;

    public void ResetBounds() => boundsOverride = null;

    public void ResetLocalBounds() => localBoundsOverride = null;

    internal override void OnAdded() => RegisteredRenderers.Add(this);

    internal override void OnRemoved() => RegisteredRenderers.Remove(this);

    internal void SetEnabledRaw(bool value) => isEnabled = value;
}
