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
