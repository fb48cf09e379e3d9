using System.Numerics;

namespace Headless.Vulkan;

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

    /// <summary>Array layer, cube face or 3D slice drawn to; -1 for all layers, which the vertex stage chooses from.</summary>
    public int Slice { get; init; }

    /// <summary>One-sample texture that receives the resolved image when drawing ends; null for none.</summary>
    public GpuTexture? Resolve { get; init; }
}
