namespace Headless.Vulkan;

/// <summary>Components of a vertex attribute.</summary>
public enum GpuVertexFormat
{
    /// <summary>One 32-bit float.</summary>
    Float1,

    /// <summary>Two 32-bit floats.</summary>
    Float2,

    /// <summary>Three 32-bit floats.</summary>
    Float3,

    /// <summary>Four 32-bit floats.</summary>
    Float4,

    /// <summary>Two 16-bit floats.</summary>
    Half2,

    /// <summary>Four 16-bit floats.</summary>
    Half4,

    /// <summary>Four bytes, 0 to 1.</summary>
    UNorm8x4,

    /// <summary>One unsigned integer.</summary>
    UInt1,

    /// <summary>Two unsigned integers.</summary>
    UInt2,

    /// <summary>Three unsigned integers.</summary>
    UInt3,

    /// <summary>Four unsigned integers.</summary>
    UInt4,
}
