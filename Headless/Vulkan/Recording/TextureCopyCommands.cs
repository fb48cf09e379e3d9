using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Records uploads, copies, resolves, mip generation and clears of textures.</summary>
internal sealed unsafe class TextureCopyCommands(CommandStream stream)
{
    private const VkPipelineStageFlags2 Stage = VkPipelineStageFlags2.AllTransfer;

    public void Update(GpuTexture texture, int mip, int layer, ReadOnlySpan<byte> data)
    {
        texture.CheckSubresource(mip, layer);
        int expected = texture.MipBytes(mip);
        if (data.Length != expected || texture.Description.Samples > 1)
        {
            throw new GpuException($"Texture '{texture.Name}': level {mip} takes {expected} bytes and one sample, not {data.Length} bytes and {texture.Description.Samples}.");
        }

        stream.Begin();
        HostSlice slice = stream.Current.Uploads.Allocate(data.Length, 16);
        data.CopyTo(slice.Bytes);
        stream.Hazards.Use(texture, VkImageLayout.TransferDstOptimal, write: true, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkBufferImageCopy region = Region(texture, mip, layer, slice.Offset);
        Vk.vkCmdCopyBufferToImage(stream.Commands, slice.Block.Buffer, texture.Handle, VkImageLayout.TransferDstOptimal, 1, &region);
        stream.Count();
    }

    public void Copy(GpuTexture source, int sourceMip, int sourceLayer, GpuTexture target, int targetMip, int targetLayer)
    {
        source.CheckSubresource(sourceMip, sourceLayer);
        target.CheckSubresource(targetMip, targetLayer);
        (int width, int height, int depth) = source.MipSize(sourceMip);
        if (source.Info.Bytes != target.Info.Bytes || source.IsDepth != target.IsDepth || source.Description.Samples != target.Description.Samples
            || (width, height, depth) != target.MipSize(targetMip))
        {
            throw new GpuException($"Copying texture '{source.Name}' to '{target.Name}': format size, sample count and size must be the same.");
        }

        bool same = ReferenceEquals(source, target);
        VkImageLayout from = same ? VkImageLayout.General : VkImageLayout.TransferSrcOptimal;
        VkImageLayout to = same ? VkImageLayout.General : VkImageLayout.TransferDstOptimal;
        stream.Begin();
        stream.Hazards.Use(target, to, write: true, Stage);
        stream.Hazards.Use(source, from, write: false, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkImageCopy region = new()
        {
            srcSubresource = source.Subresource(sourceMip, sourceLayer),
            dstSubresource = target.Subresource(targetMip, targetLayer),
            extent = Extent(width, height, depth),
        };
        Vk.vkCmdCopyImage(stream.Commands, source.Handle, from, target.Handle, to, 1, &region);
        stream.Count();
    }

    public void Resolve(GpuTexture source, GpuTexture target)
    {
        source.CheckSubresource(0, 0);
        target.CheckSubresource(0, 0);
        if (source.Description.Samples == 1 || target.Description.Samples > 1 || source.Description.Format != target.Description.Format
            || source.MipSize(0) != target.MipSize(0) || source.IsDepth)
        {
            throw new GpuException($"Resolving '{source.Name}' into '{target.Name}': needs a multisampled color texture and a one-sample texture of its format and size.");
        }

        stream.Begin();
        stream.Hazards.Use(source, VkImageLayout.TransferSrcOptimal, write: false, Stage);
        stream.Hazards.Use(target, VkImageLayout.TransferDstOptimal, write: true, Stage);
        stream.Hazards.Commit(stream.Commands);
        (int width, int height, int depth) = source.MipSize(0);
        VkImageResolve region = new()
        {
            srcSubresource = source.Subresource(0, 0),
            dstSubresource = target.Subresource(0, 0),
            extent = Extent(width, height, depth),
        };
        Vk.vkCmdResolveImage(
            stream.Commands, source.Handle, VkImageLayout.TransferSrcOptimal, target.Handle, VkImageLayout.TransferDstOptimal, 1, &region);
        stream.Count();
    }

    public void GenerateMips(GpuTexture texture)
    {
        texture.CheckSubresource(0, 0);
        if (texture.IsDepth || texture.Info.Integer)
        {
            throw new GpuException($"Texture '{texture.Name}' of format {texture.Description.Format} has no averaged mip levels.");
        }

        for (int layer = 0; layer < texture.Description.Layers; layer++)
        {
            for (int mip = 1; mip < texture.Description.MipLevels; mip++)
            {
                Halve(texture, mip, layer);
            }
        }
    }

    /// <summary>Sets all texels to zero.</summary>
    public void Clear(GpuTexture texture) => Clear(texture, 0, 0);

    public void Poison(GpuTexture texture) => Clear(texture, texture.Info.Normalised ? 0x3F800000 : uint.MaxValue, 1);

    private void Clear(GpuTexture texture, uint colorBits, float depth)
    {
        stream.Begin();
        stream.Hazards.Use(texture, VkImageLayout.TransferDstOptimal, write: true, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkImageSubresourceRange range = texture.WholeRange;
        if (texture.IsDepth)
        {
            VkClearDepthStencilValue value = new() { depth = depth };
            Vk.vkCmdClearDepthStencilImage(stream.Commands, texture.Handle, VkImageLayout.TransferDstOptimal, &value, 1, &range);
        }
        else
        {
            VkClearColorValue value = default;
            new Span<uint>(value.uint32, 4).Fill(colorBits);
            Vk.vkCmdClearColorImage(stream.Commands, texture.Handle, VkImageLayout.TransferDstOptimal, &value, 1, &range);
        }

        stream.Count();
    }

    /// <summary>The copy of one whole mip level and layer between a buffer and a texture.</summary>
    public static VkBufferImageCopy Region(GpuTexture texture, int mip, int layer, long bufferOffset)
    {
        (int width, int height, int depth) = texture.MipSize(mip);
        return new VkBufferImageCopy
        {
            bufferOffset = (ulong)bufferOffset,
            imageSubresource = texture.Subresource(mip, layer),
            imageExtent = Extent(width, height, depth),
        };
    }

    private static VkExtent3D Extent(int width, int height, int depth) =>
        new() { width = (uint)width, height = (uint)height, depth = (uint)depth };

    private void Halve(GpuTexture texture, int mip, int layer)
    {
        stream.Begin();
        stream.Hazards.Use(texture, VkImageLayout.General, write: true, Stage);
        stream.Hazards.Commit(stream.Commands);
        VkImageBlit region = new() { srcSubresource = texture.Subresource(mip - 1, layer), dstSubresource = texture.Subresource(mip, layer) };
        region.srcOffsets[1] = Corner(texture.MipSize(mip - 1));
        region.dstOffsets[1] = Corner(texture.MipSize(mip));
        Vk.vkCmdBlitImage(
            stream.Commands, texture.Handle, VkImageLayout.General, texture.Handle, VkImageLayout.General, 1, &region, VkFilter.Linear);
        stream.Count();
    }

    private static VkOffset3D Corner((int X, int Y, int Z) size) => new() { x = size.X, y = size.Y, z = size.Z };
}
