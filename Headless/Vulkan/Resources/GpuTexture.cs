using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A texture in device memory.</summary>
public sealed unsafe class GpuTexture : GpuResource
{
    private readonly DeviceContext context;
    private readonly SubmissionRing ring;
    private readonly MemoryAllocation memory;

    internal GpuTexture(DeviceContext context, SubmissionRing ring, GpuTextureDescription description, string name) : base(name)
    {
        this.context = context;
        this.ring = ring;
        Description = description;
        Info = FormatTable.Of(description.Format);
        TextureCheck.Validate(context, description, name);
        VkImageCreateInfo info = TextureCheck.ImageInfo(description);
        VkImage handle;
        Vk.vkCreateImage(context.Handle, &info, null, &handle).Check($"Creating texture '{name}'");
        Handle = handle;
        VkMemoryRequirements requirements;
        Vk.vkGetImageMemoryRequirements(context.Handle, handle, &requirements);
        try
        {
            memory = context.Memory.Allocate(requirements, linear: false, name);
        }
        catch
        {
            Vk.vkDestroyImage(context.Handle, handle, null);
            throw;
        }

        Vk.vkBindImageMemory(context.Handle, handle, memory.Memory, memory.Offset).Check($"Binding texture '{name}'");
        Views = new TextureViews(context, this);
        context.SetName(VkObjectType.Image, handle.Handle, name);
        context.Resources.Add(this);
    }

    /// <summary>Size, format and use.</summary>
    public GpuTextureDescription Description { get; }

    internal VkImage Handle { get; }

    internal FormatInfo Info { get; }

    internal TextureViews Views { get; }

    internal VkImageLayout Layout { get; set; } = VkImageLayout.Undefined;

    internal bool IsDepth => Info.Aspect == VkImageAspectFlags.Depth;

    internal VkImageSubresourceRange WholeRange => new()
    {
        aspectMask = Info.Aspect,
        levelCount = (uint)Description.MipLevels,
        layerCount = (uint)Description.Layers,
    };

    /// <summary>Width, height and depth of a mip level in texels.</summary>
    public (int Width, int Height, int Depth) MipSize(int level) =>
        (Math.Max(1, Description.Width >> level), Math.Max(1, Description.Height >> level), Math.Max(1, Description.Depth >> level));

    /// <summary>Bytes of one layer of a mip level (all slices of a 3D texture) with tightly packed rows.</summary>
    public int MipBytes(int level)
    {
        (int width, int height, int depth) = MipSize(level);
        return checked(width * height * depth * Info.Bytes);
    }

    internal VkImageSubresourceLayers Subresource(int mip, int layer) => new()
    {
        aspectMask = Info.Aspect,
        mipLevel = (uint)mip,
        baseArrayLayer = (uint)layer,
        layerCount = 1,
    };

    internal void CheckSubresource(int mip, int layer)
    {
        ThrowIfDisposed();
        if (mip < 0 || mip >= Description.MipLevels || layer < 0 || layer >= Description.Layers)
        {
            throw new GpuException(
                $"Texture '{Name}' has {Description.MipLevels} mip levels and {Description.Layers} layers; level {mip} of layer {layer} is not in it.");
        }
    }

    internal void Require(TextureUse use, VkImageViewType view, string user, string property)
    {
        if ((Description.Usage & use) == 0)
        {
            throw new GpuException($"'{user}': texture '{Name}' is bound to '{property}' but was not created for use as {use}.");
        }

        bool fits = Description.Dimension switch
        {
            GpuTextureDimension.Texture3D => view == VkImageViewType._3d,
            GpuTextureDimension.Cube => view is VkImageViewType.Cube or VkImageViewType._2dArray,
            _ => view is VkImageViewType._2d or VkImageViewType._2dArray,
        };
        if (!fits)
        {
            throw new GpuException($"'{user}': '{property}' wants a texture of shape {view.ToString().TrimStart('_')}; '{Name}' is {Description.Dimension}.");
        }
    }

    private protected override void Release()
    {
        context.Resources.Remove(this);
        context.Memory.Discount(memory);
        VkDevice device = context.Handle;
        ring.ReleaseLater(() =>
        {
            Views.Destroy();
            Vk.vkDestroyImage(device, Handle, null);
            context.Memory.Free(memory);
        });
    }
}
