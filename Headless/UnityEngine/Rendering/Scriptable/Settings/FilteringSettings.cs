namespace UnityEngine.Rendering;

/// <summary>Which of the culled objects a renderer list has.</summary>
public record struct FilteringSettings
{
    public FilteringSettings(
        RenderQueueRange? renderQueueRange = null, int layerMask = -1, uint renderingLayerMask = uint.MaxValue, int excludeMotionVectorObjects = 0)
    {
        this.renderQueueRange = renderQueueRange ?? RenderQueueRange.all;
        this.layerMask = layerMask;
        this.renderingLayerMask = renderingLayerMask;
        this.excludeMotionVectorObjects = excludeMotionVectorObjects != 0;
        sortingLayerRange = SortingLayerRange.all;
    }

    public static FilteringSettings defaultValue => new(RenderQueueRange.all);

    public RenderQueueRange renderQueueRange { get; set; }
    public int layerMask { get; set; }
    public uint renderingLayerMask { get; set; }
    public bool excludeMotionVectorObjects { get; set; }
    public SortingLayerRange sortingLayerRange { get; set; }
}
