using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The views of one texture, made when first asked for.</summary>
internal sealed unsafe class TextureViews(DeviceContext context, GpuTexture texture)
{
    private readonly List<(VkImageViewType Type, int Mip, int Mips, int Layer, int Layers, VkImageView View)> views = [];

    public VkImageView Get(VkImageViewType type, int mip, int mips, int layer, int layers)
    {
        foreach ((VkImageViewType knownType, int knownMip, int knownMips, int knownLayer, int knownLayers, VkImageView known) in views)
        {
            if (knownType == type && knownMip == mip && knownMips == mips && knownLayer == layer && knownLayers == layers)
            {
                return known;
            }
        }

        FormatInfo format = FormatTable.Of(texture.Description.Format);
        VkImageViewCreateInfo info = new()
        {
            image = texture.Handle,
            viewType = type,
            format = format.Format,
            subresourceRange = new VkImageSubresourceRange
            {
                aspectMask = format.Aspect,
                baseMipLevel = (uint)mip,
                levelCount = (uint)mips,
                baseArrayLayer = (uint)layer,
                layerCount = (uint)layers,
            },
        };
        VkImageView view;
        Vk.vkCreateImageView(context.Handle, &info, null, &view).Check($"Creating a view of texture '{texture.Name}'");
        context.SetName(VkObjectType.ImageView, view.Handle, texture.Name);
        views.Add((type, mip, mips, layer, layers, view));
        return view;
    }

    public void Destroy()
    {
        views.ForEach(entry => Vk.vkDestroyImageView(context.Handle, entry.View, null));
        views.Clear();
    }
}
