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

/// <summary>What lies outside 0 to 1.</summary>
public enum GpuWrap
{
    /// <summary>Repeats.</summary>
    Repeat,

    /// <summary>The edge texel.</summary>
    Clamp,

    /// <summary>Mirrored repeats.</summary>
    Mirror,

    /// <summary>Mirrored once, then the edge texel.</summary>
    MirrorOnce,
}

/// <summary>Content of a sampler; equal descriptions share one sampler.</summary>
public sealed record GpuSamplerDescription
{
    /// <summary>Filter.</summary>
    public GpuFilter Filter { get; init; } = GpuFilter.Bilinear;

    /// <summary>Wrap along u.</summary>
    public GpuWrap WrapU { get; init; }

    /// <summary>Wrap along v.</summary>
    public GpuWrap WrapV { get; init; }

    /// <summary>Wrap along w.</summary>
    public GpuWrap WrapW { get; init; }

    /// <summary>Samples along the steepest direction; 1 is off.</summary>
    public int Anisotropy { get; init; } = 1;

    /// <summary>Comparison for SampleCmp; null for an ordinary sampler.</summary>
    public GpuCompare? Compare { get; init; }

    /// <summary>Added to the mip level.</summary>
    public float MipBias { get; init; }
}
