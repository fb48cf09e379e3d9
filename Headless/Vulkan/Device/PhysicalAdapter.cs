using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A physical device with what the driver says of it.</summary>
internal sealed record PhysicalAdapter(VkPhysicalDevice Handle, AdapterInfo Info, VkPhysicalDeviceProperties Properties, string CacheKey);
