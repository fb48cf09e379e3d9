namespace UnityEngine.Rendering.Universal;

/// <summary>What is drawn, for any camera.</summary>
public class UniversalRenderingData : ContextItem
{
    public CullingResults cullResults;
    public bool supportsDynamicBatching;
    public PerObjectData perObjectData;

    public RenderingMode renderingMode { get; internal set; }
    public LayerMask opaqueLayerMask { get; internal set; }
    public LayerMask transparentLayerMask { get; internal set; }

    public override void Reset() => (cullResults, supportsDynamicBatching, perObjectData) = (default, false, default);
}
