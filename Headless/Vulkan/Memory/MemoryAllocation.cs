using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A piece of device memory.</summary>
internal readonly record struct MemoryAllocation(MemoryBlock Block, ulong Offset, ulong Size)
{
    public VkDeviceMemory Memory => Block.Memory;
}
