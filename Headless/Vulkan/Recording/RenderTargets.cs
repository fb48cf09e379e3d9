using System.Numerics;

namespace Headless.Vulkan;

/// <summary>What happens to a target's content when drawing begins.</summary>
public enum TargetLoad
{
    /// <summary>Kept.</summary>
    Load,

    /// <summary>Set to the clear value.</summary>
    Clear,

    /// <summary>Undefined; every texel will be drawn.</summary>
    Discard,
}

/// <summary>A color target.</summary>
/// <param name="Texture">Texture with <see cref="TextureUse.RenderTarget"/>.</param>
public sealed record ColorTarget(GpuTexture Texture)
{
    /// <summary>What happens to the old content.</summary>
    public TargetLoad Load { get; init; }

    /// <summary>Clear value, linear RGBA.</summary>
    public Vector4 Clear { get; init; }

    /// <summary>Mip level drawn to.</summary>
    public int MipLevel { get; init; }

    /// <summary>Array layer, cube face or 3D slice drawn to.</summary>
    public int Slice { get; init; }

    /// <summary>One-sample texture that receives the resolved image when drawing ends; null for none.</summary>
    public GpuTexture? Resolve { get; init; }
}

/// <summary>A depth target.</summary>
/// <param name="Texture">Texture of a depth format.</param>
public sealed record DepthTarget(GpuTexture Texture)
{
    /// <summary>What happens to the old content.</summary>
    public TargetLoad Load { get; init; }

    /// <summary>Clear depth, 0 to 1.</summary>
    public float Clear { get; init; }

    /// <summary>Mip level drawn to.</summary>
    public int MipLevel { get; init; }

    /// <summary>Array layer or cube face drawn to.</summary>
    public int Slice { get; init; }
}

/// <summary>Viewport in texels, origin at the top left as in D3D11.</summary>
public readonly record struct GpuViewport(float X, float Y, float Width, float Height, float MinDepth = 0, float MaxDepth = 1);

/// <summary>The targets of a run of draws.</summary>
public sealed record RenderTargets
{
    /// <summary>Color targets in order; may be empty with a depth target.</summary>
    public IReadOnlyList<ColorTarget> Colors { get; init; } = [];

    /// <summary>Depth target or null.</summary>
    public DepthTarget? Depth { get; init; }

    /// <summary>Viewport; null covers the targets.</summary>
    public GpuViewport? Viewport { get; init; }
}
