namespace Headless.Vulkan;

/// <summary>Blending of one color target; the default writes the source.</summary>
public sealed record BlendState
{
    /// <summary>Source factor of color.</summary>
    public GpuBlend SourceColor { get; init; } = GpuBlend.One;

    /// <summary>Target factor of color.</summary>
    public GpuBlend TargetColor { get; init; } = GpuBlend.Zero;

    /// <summary>Operation of color.</summary>
    public GpuBlendOperation ColorOperation { get; init; }

    /// <summary>Source factor of alpha.</summary>
    public GpuBlend SourceAlpha { get; init; } = GpuBlend.One;

    /// <summary>Target factor of alpha.</summary>
    public GpuBlend TargetAlpha { get; init; } = GpuBlend.Zero;

    /// <summary>Operation of alpha.</summary>
    public GpuBlendOperation AlphaOperation { get; init; }

    /// <summary>Channels that are written.</summary>
    public GpuColorMask WriteMask { get; init; } = GpuColorMask.All;

    /// <summary>Source replaces target; no blending unit needed.</summary>
    public bool IsOpaque =>
        SourceColor == GpuBlend.One && TargetColor == GpuBlend.Zero && ColorOperation == GpuBlendOperation.Add &&
        SourceAlpha == GpuBlend.One && TargetAlpha == GpuBlend.Zero && AlphaOperation == GpuBlendOperation.Add;
}
