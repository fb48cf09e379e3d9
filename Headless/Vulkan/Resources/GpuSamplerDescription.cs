namespace Headless.Vulkan;

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
