namespace UnityEngine.Rendering;

/// <summary>Render state that takes the place of the passes' own, as far as the mask says.</summary>
public record struct RenderStateBlock
{
    public RenderStateBlock(RenderStateMask mask)
    {
        blendState = BlendState.defaultValue;
        rasterState = RasterState.defaultValue;
        depthState = DepthState.defaultValue;
        stencilState = StencilState.defaultValue;
        this.mask = mask;
    }

    public BlendState blendState { get; set; }
    public RasterState rasterState { get; set; }
    public DepthState depthState { get; set; }
    public StencilState stencilState { get; set; }
    public int stencilReference { get; set; }
    public RenderStateMask mask { get; set; }
}
