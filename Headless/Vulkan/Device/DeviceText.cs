using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Vulkan's packed numbers as text.</summary>
internal static class DeviceText
{
    public static string Version(uint packed) => $"{(packed >> 22) & 0x7f}.{(packed >> 12) & 0x3ff}.{packed & 0xfff}";

    public static string Type(VkPhysicalDeviceType type) => type switch
    {
        VkPhysicalDeviceType.DiscreteGpu => "DiscreteGpu",
        VkPhysicalDeviceType.IntegratedGpu => "IntegratedGpu",
        VkPhysicalDeviceType.VirtualGpu => "VirtualGpu",
        VkPhysicalDeviceType.Cpu => "Cpu",
        _ => "Other",
    };

    public static string Size(long bytes) => bytes >= 1 << 20 ? $"{bytes / 1048576.0:0.#} MiB" : $"{bytes} bytes";
}
