using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A mapped buffer for constant data, uploads or read-backs.</summary>
internal sealed unsafe class HostBlock : IDisposable
{
    private readonly DeviceContext context;
    private readonly VkDeviceMemory memory;

    public HostBlock(DeviceContext context, long size, bool readback)
    {
        this.context = context;
        Size = size;
        string name = readback ? "read-back" : "upload";
        VkBufferUsageFlags usage = readback
            ? VkBufferUsageFlags.TransferDst
            : VkBufferUsageFlags.TransferSrc | VkBufferUsageFlags.UniformBuffer;
        VkBufferCreateInfo info = new() { size = (ulong)size, usage = usage, sharingMode = VkSharingMode.Exclusive };
        VkBuffer buffer;
        Vk.vkCreateBuffer(context.Handle, &info, null, &buffer).Check($"Creating the {name} buffer");
        Buffer = buffer;
        VkMemoryRequirements requirements;
        Vk.vkGetBufferMemoryRequirements(context.Handle, buffer, &requirements);
        VkMemoryPropertyFlags wished = readback ? VkMemoryPropertyFlags.HostCached : VkMemoryPropertyFlags.DeviceLocal;
        memory = context.Memory.AllocateHost(requirements, wished, name);
        Vk.vkBindBufferMemory(context.Handle, buffer, memory, 0).Check($"Binding the {name} buffer");
        void* mapped;
        Vk.vkMapMemory(context.Handle, memory, 0, ulong.MaxValue, 0, &mapped).Check($"Mapping the {name} buffer");
        Pointer = (byte*)mapped;
        context.SetName(VkObjectType.Buffer, buffer.Handle, name);
    }

    public VkBuffer Buffer { get; }

    public long Size { get; }

    public byte* Pointer { get; }

    public void Dispose()
    {
        Vk.vkDestroyBuffer(context.Handle, Buffer, null);
        Vk.vkFreeMemory(context.Handle, memory, null);
    }
}
