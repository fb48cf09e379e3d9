using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>One vkAllocateMemory, handed out in pieces; free ranges are kept in order and joined when they touch.</summary>
internal sealed class MemoryBlock
{
    private readonly List<(ulong Offset, ulong Size)> free;

    public MemoryBlock(VkDeviceMemory memory, ulong size, int pool)
    {
        Memory = memory;
        Size = size;
        Pool = pool;
        free = [(0, size)];
    }

    public VkDeviceMemory Memory { get; }

    public ulong Size { get; }

    /// <summary>Which allocator pool it belongs to.</summary>
    public int Pool { get; }

    public bool IsEmpty => free.Count == 1 && free[0].Size == Size;

    /// <summary>First free range that fits; false when none does.</summary>
    public bool TryAllocate(ulong size, ulong alignment, out MemoryAllocation allocation)
    {
        for (int i = 0; i < free.Count; i++)
        {
            (ulong offset, ulong length) = free[i];
            ulong start = (offset + alignment - 1) / alignment * alignment;
            ulong end = start + size;
            if (end > offset + length)
            {
                continue;
            }

            free.RemoveAt(i);
            if (end < offset + length)
            {
                free.Insert(i, (end, offset + length - end));
            }

            if (start > offset)
            {
                free.Insert(i, (offset, start - offset));
            }

            allocation = new MemoryAllocation(this, start, size);
            return true;
        }

        allocation = default;
        return false;
    }

    public void Free(MemoryAllocation allocation)
    {
        int index = free.FindIndex(range => range.Offset > allocation.Offset);
        index = index < 0 ? free.Count : index;
        free.Insert(index, (allocation.Offset, allocation.Size));
        Join(index);
        Join(index - 1);
    }

    private void Join(int index)
    {
        if (index >= 0 && index + 1 < free.Count && free[index].Offset + free[index].Size == free[index + 1].Offset)
        {
            free[index] = (free[index].Offset, free[index].Size + free[index + 1].Size);
            free.RemoveAt(index + 1);
        }
    }
}
