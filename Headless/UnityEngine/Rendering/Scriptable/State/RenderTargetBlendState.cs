namespace UnityEngine.Rendering;

/// <summary>How one render target is blended.</summary>
public record struct RenderTargetBlendState
{
    public RenderTargetBlendState(
        ColorWriteMask writeMask = ColorWriteMask.All, BlendMode sourceColorBlendMode = BlendMode.One, BlendMode destinationColorBlendMode = BlendMode.Zero,
        BlendMode sourceAlphaBlendMode = BlendMode.One, BlendMode destinationAlphaBlendMode = BlendMode.Zero,
        BlendOp colorBlendOperation = BlendOp.Add, BlendOp alphaBlendOperation = BlendOp.Add)
    {
        this.writeMask = writeMask;
        this.sourceColorBlendMode = sourceColorBlendMode;
        this.destinationColorBlendMode = destinationColorBlendMode;
        this.sourceAlphaBlendMode = sourceAlphaBlendMode;
        this.destinationAlphaBlendMode = destinationAlphaBlendMode;
        this.colorBlendOperation = colorBlendOperation;
        this.alphaBlendOperation = alphaBlendOperation;
    }

    public static RenderTargetBlendState defaultValue => new(ColorWriteMask.All);

    public ColorWriteMask writeMask { get; set; }
    public BlendMode sourceColorBlendMode { get; set; }
    public BlendMode destinationColorBlendMode { get; set; }
    public BlendMode sourceAlphaBlendMode { get; set; }
    public BlendMode destinationAlphaBlendMode { get; set; }
    public BlendOp colorBlendOperation { get; set; }
    public BlendOp alphaBlendOperation { get; set; }
}
