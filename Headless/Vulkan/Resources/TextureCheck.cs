using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Checks a texture description against the device and writes it as Vulkan's.</summary>
internal static unsafe class TextureCheck
{
    public static void Validate(DeviceContext context, GpuTextureDescription d, string name)
    {
        GpuLimits limits = context.Limits;
        bool volume = d.Dimension == GpuTextureDimension.Texture3D;
        int side = volume ? limits.MaxTexture3D : limits.MaxTexture2D;
        string size = $"{d.Width} x {d.Height} x {d.Depth}, {d.Layers} layers, {d.MipLevels} mip levels";
        if (d.Width <= 0 || d.Height <= 0 || d.Depth <= 0 || d.Layers <= 0 || d.MipLevels <= 0)
        {
            throw new GpuException($"Texture '{name}' has the size {size}; every size is at least 1.");
        }

        if (d.Width > side || d.Height > side || d.Depth > side || d.Layers > limits.MaxTextureLayers)
        {
            throw new GpuException($"Texture '{name}' is {size}; device '{context.Adapter.Name}' allows sides of {side} and {limits.MaxTextureLayers} layers.");
        }

        if ((!volume && d.Depth != 1) || (volume && d.Layers != 1) || (d.Dimension == GpuTextureDimension.Texture2D && d.Layers != 1)
            || (d.Dimension == GpuTextureDimension.Cube && (d.Layers != 6 || d.Width != d.Height)))
        {
            throw new GpuException($"Texture '{name}' is {size}, which is not a {d.Dimension}.");
        }

        int longest = Math.Max(d.Width, Math.Max(d.Height, d.Depth));
        if (d.MipLevels > 1 + int.Log2(longest))
        {
            throw new GpuException($"Texture '{name}' is {size}: it has at most {1 + int.Log2(longest)} mip levels.");
        }

        if ((limits.SampleCounts & d.Samples) == 0 || (d.Samples > 1 && (d.MipLevels > 1 || d.Dimension is not (GpuTextureDimension.Texture2D or GpuTextureDimension.Texture2DArray))))
        {
            throw new GpuException($"Texture '{name}': {d.Samples} samples need a 2D texture without mip levels and a device with that count.");
        }

        CheckFormat(context, d, name);
    }

    public static VkImageCreateInfo ImageInfo(GpuTextureDescription d)
    {
        FormatInfo format = FormatTable.Of(d.Format);
        bool depth = format.Aspect == VkImageAspectFlags.Depth;
        VkImageUsageFlags usage = VkImageUsageFlags.TransferSrc | VkImageUsageFlags.TransferDst;
        usage |= d.Usage.HasFlag(TextureUse.Sampled) ? VkImageUsageFlags.Sampled : 0;
        usage |= d.Usage.HasFlag(TextureUse.Storage) ? VkImageUsageFlags.Storage : 0;
        VkImageUsageFlags target = depth ? VkImageUsageFlags.DepthStencilAttachment : VkImageUsageFlags.ColorAttachment;
        usage |= d.Usage.HasFlag(TextureUse.RenderTarget) ? target : 0;
        bool volume = d.Dimension == GpuTextureDimension.Texture3D;
        VkImageCreateFlags flags = d.Dimension == GpuTextureDimension.Cube ? VkImageCreateFlags.CubeCompatible : 0;
        flags |= volume && d.Usage.HasFlag(TextureUse.RenderTarget) ? VkImageCreateFlags._2dArrayCompatible : 0;
        return new VkImageCreateInfo
        {
            flags = flags,
            imageType = volume ? VkImageType._3d : VkImageType._2d,
            format = format.Format,
            extent = new VkExtent3D { width = (uint)d.Width, height = (uint)d.Height, depth = (uint)d.Depth },
            mipLevels = (uint)d.MipLevels,
            arrayLayers = (uint)d.Layers,
            samples = (VkSampleCountFlags)d.Samples,
            tiling = VkImageTiling.Optimal,
            usage = usage,
            sharingMode = VkSharingMode.Exclusive,
            initialLayout = VkImageLayout.Undefined,
        };
    }

    private static void CheckFormat(DeviceContext context, GpuTextureDescription d, string name)
    {
        FormatInfo format = FormatTable.Of(d.Format);
        VkFormatProperties properties;
        Vk.vkGetPhysicalDeviceFormatProperties(context.Physical.Handle, format.Format, &properties);
        VkFormatFeatureFlags target = format.Aspect == VkImageAspectFlags.Depth ? VkFormatFeatureFlags.DepthStencilAttachment : VkFormatFeatureFlags.ColorAttachment;
        VkFormatFeatureFlags needed = VkFormatFeatureFlags.None;
        needed |= d.Usage.HasFlag(TextureUse.Sampled) ? VkFormatFeatureFlags.SampledImage : 0;
        needed |= d.Usage.HasFlag(TextureUse.Storage) ? VkFormatFeatureFlags.StorageImage : 0;
        needed |= d.Usage.HasFlag(TextureUse.RenderTarget) ? target : 0;
        VkFormatFeatureFlags missing = needed & ~properties.optimalTilingFeatures;
        if (missing != 0)
        {
            throw new GpuException($"Texture '{name}': device '{context.Adapter.Name}' has no {missing} for the format {d.Format}.");
        }
    }
}
