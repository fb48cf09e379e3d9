namespace UnityEngine.Rendering;

/// <summary>How the render targets are blended; all as the first unless separateMRTBlendStates.</summary>
public record struct BlendState
{
    public BlendState(bool separateMRTBlend = false, bool alphaToMask = false)
    {
        blendState0 = blendState1 = blendState2 = blendState3 = RenderTargetBlendState.defaultValue;
        blendState4 = blendState5 = blendState6 = blendState7 = RenderTargetBlendState.defaultValue;
        separateMRTBlendStates = separateMRTBlend;
        this.alphaToMask = alphaToMask;
    }

    public static BlendState defaultValue => new(false);

    public bool separateMRTBlendStates { get; set; }
    public bool alphaToMask { get; set; }
    public RenderTargetBlendState blendState0 { get; set; }
    public RenderTargetBlendState blendState1 { get; set; }
    public RenderTargetBlendState blendState2 { get; set; }
    public RenderTargetBlendState blendState3 { get; set; }
    public RenderTargetBlendState blendState4 { get; set; }
    public RenderTargetBlendState blendState5 { get; set; }
    public RenderTargetBlendState blendState6 { get; set; }
    public RenderTargetBlendState blendState7 { get; set; }
}
