using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Sub-allocates device memory from blocks of 64 MiB; requests above a quarter of that get a block of their own.</summary>
internal sealed unsafe class MemoryAllocator : IDisposable
{
    private const ulong BlockSize = 64 << 20;
    private const ulong LargeSize = BlockSize / 4;

    private readonly DeviceContext context;
    private readonly VkPhysicalDeviceMemoryProperties properties;
    private readonly Dictionary<int, List<MemoryBlock>> pools = [];

    public MemoryAllocator(DeviceContext context)
    {
        this.context = context;
        VkPhysicalDeviceMemoryProperties read;
        Vk.vkGetPhysicalDeviceMemoryProperties(context.Physical.Handle, &read);
        properties = read;
    }

    /// <summary>Bytes in live buffers and textures.</summary>
    public long AllocatedBytes { get; private set; }

    /// <summary>Called when memory runs out, to free what the device has finished with; then the request is tried again.</summary>
    public Action? Reclaim { get; set; }

    /// <summary>Device-local memory; linear (buffers) and tiled (textures) resources live in separate blocks.</summary>
    public MemoryAllocation Allocate(VkMemoryRequirements requirements, bool linear, string name)
    {
        int type = FindType(requirements.memoryTypeBits, VkMemoryPropertyFlags.DeviceLocal, VkMemoryPropertyFlags.None)
            ?? FindType(requirements.memoryTypeBits, VkMemoryPropertyFlags.None, VkMemoryPropertyFlags.None)
            ?? throw new GpuException($"'{name}': no memory type of the device takes it.");
        int pool = (type * 2) + (linear ? 0 : 1);
        if (!pools.TryGetValue(pool, out List<MemoryBlock>? blocks))
        {
            pools[pool] = blocks = [];
        }

        AllocatedBytes += (long)requirements.size;
        if (requirements.size <= LargeSize)
        {
            foreach (MemoryBlock block in blocks)
            {
                if (block.TryAllocate(requirements.size, requirements.alignment, out MemoryAllocation shared))
                {
                    return shared;
                }
            }
        }

        try
        {
            ulong size = requirements.size <= LargeSize ? BlockSize : requirements.size;
            MemoryBlock fresh = new(AllocateMemory(size, (uint)type, $"Allocating {DeviceText.Size((long)size)} for '{name}'", Reclaim), size, pool);
            blocks.Add(fresh);
            fresh.TryAllocate(requirements.size, requirements.alignment, out MemoryAllocation allocation);
            return allocation;
        }
        catch
        {
            AllocatedBytes -= (long)requirements.size;
            throw;
        }
    }

    /// <summary>Takes a disposed resource out of <see cref="AllocatedBytes"/>; its memory follows by <see cref="Free"/>.</summary>
    public void Discount(MemoryAllocation allocation) => AllocatedBytes -= (long)allocation.Size;

    public void Free(MemoryAllocation allocation)
    {
        MemoryBlock block = allocation.Block;
        block.Free(allocation);
        List<MemoryBlock> blocks = pools[block.Pool];
        bool spare = block.Size == BlockSize && !blocks.Exists(other => other != block && other.IsEmpty);
        if (block.IsEmpty && !spare)
        {
            blocks.Remove(block);
            Vk.vkFreeMemory(context.Handle, block.Memory, null);
        }
    }

    /// <summary>
    /// Memory that the host can map: of the wished properties where there is a type for them that is not full. Often a card shows the host
    /// 256 MiB of its own.
    /// </summary>
    public VkDeviceMemory AllocateHost(VkMemoryRequirements requirements, VkMemoryPropertyFlags wished, string name)
    {
        const VkMemoryPropertyFlags Needed = VkMemoryPropertyFlags.HostVisible | VkMemoryPropertyFlags.HostCoherent;
        string what = $"Allocating {DeviceText.Size((long)requirements.size)} of host memory for '{name}'";
        int type = FindType(requirements.memoryTypeBits, Needed, wished)
            ?? throw new GpuException($"'{name}': the device has no host-visible memory.");
        try
        {
            return AllocateMemory(requirements.size, (uint)type, what, null);
        }
        catch (GpuException) when (FindType(requirements.memoryTypeBits & ~(1u << type), Needed, VkMemoryPropertyFlags.None) is { } other)
        {
            return AllocateMemory(requirements.size, (uint)other, what, null);
        }
    }

    public void Dispose()
    {
        foreach (MemoryBlock block in pools.Values.SelectMany(blocks => blocks))
        {
            Vk.vkFreeMemory(context.Handle, block.Memory, null);
        }

        pools.Clear();
    }

    private int? FindType(uint allowed, VkMemoryPropertyFlags needed, VkMemoryPropertyFlags wished)
    {
        int? found = null;
        for (int i = 0; i < properties.memoryTypeCount; i++)
        {
            VkMemoryPropertyFlags flags = properties.memoryTypes[i].propertyFlags;
            if ((allowed & (1u << i)) == 0 || (flags & needed) != needed)
            {
                continue;
            }

            if ((flags & wished) == wished)
            {
                return i;
            }

            found ??= i;
        }

        return found;
    }

    private VkDeviceMemory AllocateMemory(ulong size, uint type, string what, Action? reclaim)
    {
        VkMemoryAllocateInfo info = new() { allocationSize = size, memoryTypeIndex = type };
        VkDeviceMemory memory;
        VkResult result = Vk.vkAllocateMemory(context.Handle, &info, null, &memory);
        if ((result is VkResult.ErrorOutOfDeviceMemory or VkResult.ErrorOutOfHostMemory) && reclaim is not null)
        {
            reclaim();
            result = Vk.vkAllocateMemory(context.Handle, &info, null, &memory);
        }

        result.Check(what);
        return memory;
    }
}
