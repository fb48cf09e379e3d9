using System.Runtime.CompilerServices;

namespace Headless.Vulkan.Native;

internal static class ResultCheck
{
    /// <summary>Throws a named error for a negative result; <paramref name="what"/> says what was tried.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Check(this VkResult result, string what)
    {
        if (result < VkResult.Success)
        {
            Throw(result, what);
        }
    }

    private static void Throw(VkResult result, string what)
    {
        string cure = result switch
        {
            VkResult.ErrorOutOfDeviceMemory => "the device's memory is full: use fewer or smaller buffers and textures",
            VkResult.ErrorOutOfHostMemory => "the machine's memory is full",
            VkResult.ErrorDeviceLost => "the device was lost: a shader ran too long or wrote out of bounds, or the driver failed",
            VkResult.ErrorIncompatibleDriver => "no Vulkan driver is installed; on Debian: apt install mesa-vulkan-drivers",
            VkResult.ErrorInitializationFailed => "the driver failed to start",
            _ => "the driver refused",
        };
        throw new GpuException($"{what} failed ({result}): {cure}.");
    }
}
