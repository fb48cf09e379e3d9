namespace Headless.Vulkan;

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

    /// <summary>Array layer or cube face drawn to; -1 for all layers.</summary>
    public int Slice { get; init; }
}
