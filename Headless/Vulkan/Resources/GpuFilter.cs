namespace Headless.Vulkan;

/// <summary>How texels between centres are read.</summary>
public enum GpuFilter
{
    /// <summary>The nearest texel of the nearest mip.</summary>
    Point,

    /// <summary>Linear in a mip, nearest mip (Unity's Bilinear).</summary>
    Bilinear,

    /// <summary>Linear in and between mips.</summary>
    Trilinear,
}
