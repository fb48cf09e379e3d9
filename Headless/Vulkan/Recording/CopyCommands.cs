using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Records copies and fills of buffers.</summary>
internal sealed unsafe class CopyCommands(CommandStream stream)
{
    private const VkPipelineStageFlags2 Stage = VkPipelineStageFlags2.AllTransfer;
    private const int PieceSize = 64 << 20;

    public void Update(GpuBuffer buffer, long offset, ReadOnlySpan<byte> data)
    {
        buffer.CheckRange(offset, data.Length, "Writing");
        for (int start = 0; start < data.Length; start += PieceSize)
        {
            ReadOnlySpan<byte> piece = data.Slice(start, Math.Min(PieceSize, data.Length - start));
            stream.Begin();
            HostSlice slice = stream.Current.Uploads.Allocate(piece.Length, 16);
            piece.CopyTo(slice.Bytes);
            stream.Hazards.Write(buffer, Stage);
            Record(slice.Block.Buffer, slice.Offset, buffer.Handle, offset + start, piece.Length);
        }
    }

    public void Copy(GpuBuffer source, long sourceOffset, GpuBuffer target, long targetOffset, long size)
    {
        source.CheckRange(sourceOffset, size, "Copying");
        target.CheckRange(targetOffset, size, "Copying");
        if (ReferenceEquals(source, target) && Math.Abs(sourceOffset - targetOffset) < size)
        {
            throw new GpuException($"Copying inside buffer '{source.Name}': the ranges overlap. Copy through another buffer.");
        }

        if (size == 0)
        {
            return;
        }

        stream.Begin();
        stream.Hazards.Read(source, Stage);
        stream.Hazards.Write(target, Stage);
        Record(source.Handle, sourceOffset, target.Handle, targetOffset, size);
    }

    public void Fill(GpuBuffer buffer, long offset, long size, uint value)
    {
        buffer.ThrowIfDisposed();
        if (offset < 0 || size < 0 || offset % 4 != 0 || size % 4 != 0 || offset + size > buffer.PaddedSize)
        {
            throw new GpuException($"Filling '{buffer.Name}' of {buffer.Size} bytes: offset {offset} and size {size} must be multiples of 4 inside it.");
        }

        if (size == 0)
        {
            return;
        }

        stream.Begin();
        stream.Hazards.Write(buffer, Stage);
        stream.Hazards.Commit(stream.Commands);
        Vk.vkCmdFillBuffer(stream.Commands, buffer.Handle, (ulong)offset, (ulong)size, value);
        stream.Count();
    }

    private void Record(VkBuffer source, long sourceOffset, VkBuffer target, long targetOffset, long size)
    {
        stream.Hazards.Commit(stream.Commands);
        VkBufferCopy region = new() { srcOffset = (ulong)sourceOffset, dstOffset = (ulong)targetOffset, size = (ulong)size };
        Vk.vkCmdCopyBuffer(stream.Commands, source, target, 1, &region);
        stream.Count();
    }
}
