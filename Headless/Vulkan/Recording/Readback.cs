using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Records copies from the device to mapped memory.</summary>
internal sealed unsafe class Readback(CommandStream stream)
{
    private const VkPipelineStageFlags2 Stage = VkPipelineStageFlags2.AllTransfer;

    public ReadbackTicket Request(GpuBuffer buffer, long offset, int size)
    {
        buffer.CheckRange(offset, size, "Reading");
        stream.Begin();
        ReadbackTicket ticket = new(stream.Ring, stream.Ring.CurrentTicket, size);
        if (size == 0)
        {
            ticket.Complete([]);
            return ticket;
        }

        HostSlice slice = stream.Current.Downloads.Allocate(size, 16);
        stream.Hazards.Read(buffer, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkBufferCopy region = new() { srcOffset = (ulong)offset, dstOffset = (ulong)slice.Offset, size = (ulong)size };
        Vk.vkCmdCopyBuffer(stream.Commands, buffer.Handle, slice.Block.Buffer, 1, &region);
        stream.Count();
        stream.Current.AddReadback(ticket, slice);
        return ticket;
    }

    public ReadbackTicket Request(GpuTexture texture, int mip, int layer)
    {
        texture.CheckSubresource(mip, layer);
        if (texture.Description.Samples > 1)
        {
            throw new GpuException($"Texture '{texture.Name}' has {texture.Description.Samples} samples: resolve it and read the result.");
        }

        stream.Begin();
        int size = texture.MipBytes(mip);
        ReadbackTicket ticket = new(stream.Ring, stream.Ring.CurrentTicket, size);
        HostSlice slice = stream.Current.Downloads.Allocate(size, 16);
        stream.Hazards.Use(texture, VkImageLayout.TransferSrcOptimal, write: false, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkBufferImageCopy region = TextureCopyCommands.Region(texture, mip, layer, slice.Offset);
        Vk.vkCmdCopyImageToBuffer(stream.Commands, texture.Handle, VkImageLayout.TransferSrcOptimal, slice.Block.Buffer, 1, &region);
        stream.Count();
        stream.Current.AddReadback(ticket, slice);
        return ticket;
    }
}
