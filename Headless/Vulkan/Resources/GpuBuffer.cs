using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A buffer in device memory.</summary>
public sealed unsafe class GpuBuffer : GpuResource
{
    private readonly DeviceContext context;
    private readonly SubmissionRing ring;
    private readonly MemoryAllocation memory;

    internal GpuBuffer(DeviceContext context, SubmissionRing ring, long size, BufferUse use, string name) : base(name)
    {
        this.context = context;
        this.ring = ring;
        Size = size;
        Use = use;
        CheckSize();
        VkBufferCreateInfo info = new() { size = (ulong)PaddedSize, usage = Usage(use), sharingMode = VkSharingMode.Exclusive };
        VkBuffer handle;
        Vk.vkCreateBuffer(context.Handle, &info, null, &handle).Check($"Creating buffer '{name}'");
        Handle = handle;
        VkMemoryRequirements requirements;
        Vk.vkGetBufferMemoryRequirements(context.Handle, handle, &requirements);
        try
        {
            memory = context.Memory.Allocate(requirements, linear: true, name);
        }
        catch
        {
            Vk.vkDestroyBuffer(context.Handle, handle, null);
            throw;
        }

        Vk.vkBindBufferMemory(context.Handle, handle, memory.Memory, memory.Offset).Check($"Binding buffer '{name}'");
        context.SetName(VkObjectType.Buffer, handle.Handle, name);
        context.Resources.Add(this);
    }

    /// <summary>Bytes.</summary>
    public long Size { get; }

    /// <summary>What it may be bound as.</summary>
    public BufferUse Use { get; }

    internal VkBuffer Handle { get; }

    /// <summary>Bytes up to the next multiple of 4, as fills need.</summary>
    internal long PaddedSize => (Size + 3) & ~3L;

    internal void Require(BufferUse use, string user, string property)
    {
        if ((Use & use) == 0)
        {
            throw new GpuException($"'{user}': buffer '{Name}' is bound to '{property}' but was not created for use as {use}.");
        }
    }

    /// <summary>Throws unless the range lies inside the buffer.</summary>
    internal void CheckRange(long offset, long size, string what)
    {
        ThrowIfDisposed();
        if (offset < 0 || size < 0 || offset + size > Size)
        {
            throw new GpuException($"{what}: bytes {offset} to {offset + size} lie outside buffer '{Name}' of {Size} bytes.");
        }
    }

    private protected override void Release()
    {
        context.Resources.Remove(this);
        context.Memory.Discount(memory);
        VkDevice device = context.Handle;
        ring.ReleaseLater(() =>
        {
            Vk.vkDestroyBuffer(device, Handle, null);
            context.Memory.Free(memory);
        });
    }

    private static VkBufferUsageFlags Usage(BufferUse use)
    {
        VkBufferUsageFlags flags = VkBufferUsageFlags.TransferSrc | VkBufferUsageFlags.TransferDst;
        flags |= use.HasFlag(BufferUse.Storage) ? VkBufferUsageFlags.StorageBuffer : 0;
        flags |= use.HasFlag(BufferUse.Indirect) ? VkBufferUsageFlags.IndirectBuffer : 0;
        flags |= use.HasFlag(BufferUse.Vertex) ? VkBufferUsageFlags.VertexBuffer : 0;
        flags |= use.HasFlag(BufferUse.Index) ? VkBufferUsageFlags.IndexBuffer : 0;
        flags |= use.HasFlag(BufferUse.Uniform) ? VkBufferUsageFlags.UniformBuffer : 0;
        return flags;
    }

    private void CheckSize()
    {
        GpuLimits limits = context.Limits;
        if (Size <= 0)
        {
            throw new GpuException($"Buffer '{Name}' has {Size} bytes; a buffer holds at least one byte.");
        }

        if (Use.HasFlag(BufferUse.Storage) && Size > limits.MaxStorageBufferRange)
        {
            throw new GpuException(
                $"Buffer '{Name}' needs {DeviceText.Size(Size)}, more than the {DeviceText.Size(limits.MaxStorageBufferRange)} that a shader of " +
                $"device '{context.Adapter.Name}' can see (MaxStorageBufferRange). Use fewer elements, or split the buffer.");
        }

        if (Size > limits.MaxAllocationSize)
        {
            throw new GpuException(
                $"Buffer '{Name}' needs {DeviceText.Size(Size)}, more than device '{context.Adapter.Name}' allocates at once " +
                $"({DeviceText.Size(limits.MaxAllocationSize)}, MaxAllocationSize). Use fewer elements, or split the buffer.");
        }
    }
}
