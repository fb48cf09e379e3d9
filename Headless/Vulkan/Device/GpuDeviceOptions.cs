namespace Headless.Vulkan;

/// <summary>How a <see cref="GpuDevice"/> is chosen and opened.</summary>
public sealed record GpuDeviceOptions
{
    /// <summary>Index or part of a name (case ignored); null takes a real GPU before a CPU driver.</summary>
    public string? Adapter { get; init; }

    /// <summary>Turns on VK_LAYER_KHRONOS_validation; its messages land in <see cref="GpuDevice.ValidationMessages"/>.</summary>
    public bool Validate { get; init; }

    /// <summary>With <see cref="Validate"/>, also checks that no command races with another; slow.</summary>
    public bool ValidateSynchronization { get; init; }

    /// <summary>
    /// Fills new buffers, textures and groupshared memory with set bits (NaN as a float) in place of zeros, as a real device
    /// may leave anything in them.
    /// </summary>
    public bool Poison { get; init; }

    /// <summary>
    /// Leaves robust access to buffers off and checks every index into buffers, groupshared and local arrays; what lies
    /// outside is named by <see cref="GpuDevice.TakeOutOfBounds"/>.
    /// </summary>
    public bool CheckBounds { get; init; }

    /// <summary>Folder of the persistent pipeline cache; null is <see cref="Files.UserCache.Folder"/>.</summary>
    public string? CacheDirectory { get; init; }
}
