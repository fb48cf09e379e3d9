namespace Headless.Vulkan;

/// <summary>Channels that are written.</summary>
[Flags]
public enum GpuColorMask
{
    /// <summary>Red.</summary>
    Red = 1,

    /// <summary>Green.</summary>
    Green = 2,

    /// <summary>Blue.</summary>
    Blue = 4,

    /// <summary>Alpha.</summary>
    Alpha = 8,

    /// <summary>All four.</summary>
    All = 15,
}
