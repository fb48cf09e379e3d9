namespace UnityEngine.Rendering;

/// <summary>Which shadow casters a shadow list has.</summary>
public record struct ShadowDrawingSettings
{
    public ShadowDrawingSettings(CullingResults cullingResults, int lightIndex)
        : this(cullingResults, lightIndex, BatchCullingProjectionType.Unknown)
    {
    }

    public ShadowDrawingSettings(CullingResults cullingResults, int lightIndex, BatchCullingProjectionType projectionType)
        : this()
    {
        this.cullingResults = cullingResults;
        this.lightIndex = lightIndex;
        this.projectionType = projectionType;
    }

    public CullingResults cullingResults { get; set; }
    public int lightIndex { get; set; }

    /// <summary>Whether casters must share a rendering layer with the light.</summary>
    public bool useRenderingLayerMaskTest { get; set; }

    public ShadowSplitData splitData { get; set; }
    public ShadowObjectsFilter objectsFilter { get; set; }
    public BatchCullingProjectionType projectionType { get; set; }
}
