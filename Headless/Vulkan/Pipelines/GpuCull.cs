namespace Headless.Vulkan;

/// <summary>Faces left out.</summary>
public enum GpuCull
{
    /// <summary>None.</summary>
    Off,

    /// <summary>Front faces.</summary>
    Front,

    /// <summary>Back faces.</summary>
    Back,
}
