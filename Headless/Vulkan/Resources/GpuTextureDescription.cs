namespace Headless.Vulkan;

/// <summary>Size, format and use of a texture; texels.</summary>
public sealed record GpuTextureDescription
{
    /// <summary>Texels along x.</summary>
    public required int Width { get; init; }

    /// <summary>Texels along y.</summary>
    public required int Height { get; init; }

    /// <summary>Texels along z; 1 unless 3D.</summary>
    public int Depth { get; init; } = 1;

    /// <summary>Array layers; 6 for a cube.</summary>
    public int Layers { get; init; } = 1;

    /// <summary>Mip levels, largest first.</summary>
    public int MipLevels { get; init; } = 1;

    /// <summary>Texel format.</summary>
    public required GpuFormat Format { get; init; }

    /// <summary>Samples a texel: 1 or 4 (others where the device has them).</summary>
    public int Samples { get; init; } = 1;

    /// <summary>What it will be bound as.</summary>
    public TextureUse Usage { get; init; } = TextureUse.Sampled;

    /// <summary>Shape.</summary>
    public GpuTextureDimension Dimension { get; init; } = GpuTextureDimension.Texture2D;
}
