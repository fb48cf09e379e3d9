namespace Headless.Vulkan;

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
