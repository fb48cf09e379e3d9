namespace Headless.Vulkan;

/// <summary>Shape of a texture.</summary>
public enum GpuTextureDimension
{
    /// <summary>Width x height.</summary>
    Texture2D,

    /// <summary>Width x height x depth.</summary>
    Texture3D,

    /// <summary>Six square layers: +X, -X, +Y, -Y, +Z, -Z.</summary>
    Cube,

    /// <summary>Layers of width x height.</summary>
    Texture2DArray,
}

/// <summary>What a texture may be bound as; copying to and from it is always allowed for one sample.</summary>
[Flags]
public enum TextureUse
{
    /// <summary>Texture2D, Texture3D, ... in shaders.</summary>
    Sampled = 1,

    /// <summary>RWTexture2D, RWTexture3D in shaders.</summary>
    Storage = 2,

    /// <summary>Color or, by format, depth target.</summary>
    RenderTarget = 4,
}

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
