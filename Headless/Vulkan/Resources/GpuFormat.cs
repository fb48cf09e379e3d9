namespace Headless.Vulkan;

/// <summary>Texel formats.</summary>
public enum GpuFormat
{
    /// <summary>No target.</summary>
    None,

    /// <summary>8-bit red, 0 to 1.</summary>
    R8Unorm,

    /// <summary>Two 8-bit channels, 0 to 1.</summary>
    R8G8Unorm,

    /// <summary>Four 8-bit channels, 0 to 1.</summary>
    R8G8B8A8Unorm,

    /// <summary>Four 8-bit channels, color in sRGB, read as linear.</summary>
    R8G8B8A8Srgb,

    /// <summary>16-bit float red.</summary>
    R16Float,

    /// <summary>Two 16-bit floats.</summary>
    R16G16Float,

    /// <summary>Four 16-bit floats.</summary>
    R16G16B16A16Float,

    /// <summary>32-bit float red.</summary>
    R32Float,

    /// <summary>Two 32-bit floats.</summary>
    R32G32Float,

    /// <summary>Four 32-bit floats.</summary>
    R32G32B32A32Float,

    /// <summary>32-bit unsigned integer.</summary>
    R32Uint,

    /// <summary>32-bit signed integer.</summary>
    R32Sint,

    /// <summary>Two 32-bit unsigned integers.</summary>
    R32G32Uint,

    /// <summary>Four 32-bit unsigned integers.</summary>
    R32G32B32A32Uint,

    /// <summary>32-bit float depth.</summary>
    D32Float,
}
