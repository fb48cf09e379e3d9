using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A sampler; created and owned by the device.</summary>
public sealed unsafe class GpuSampler
{
    internal GpuSampler(DeviceContext context, GpuSamplerDescription description)
    {
        Description = description;
        bool linear = description.Filter != GpuFilter.Point;
        bool anisotropic = description.Anisotropy > 1 && context.Features.Core.samplerAnisotropy != 0;
        VkSamplerCreateInfo info = new()
        {
            magFilter = linear ? VkFilter.Linear : VkFilter.Nearest,
            minFilter = linear ? VkFilter.Linear : VkFilter.Nearest,
            mipmapMode = description.Filter == GpuFilter.Trilinear ? VkSamplerMipmapMode.Linear : VkSamplerMipmapMode.Nearest,
            addressModeU = Address(context, description.WrapU),
            addressModeV = Address(context, description.WrapV),
            addressModeW = Address(context, description.WrapW),
            mipLodBias = description.MipBias,
            anisotropyEnable = anisotropic ? 1u : 0u,
            maxAnisotropy = anisotropic ? Math.Min(description.Anisotropy, context.Physical.Properties.limits.maxSamplerAnisotropy) : 1,
            compareEnable = description.Compare is null ? 0u : 1u,
            compareOp = VulkanStates.Compare(description.Compare ?? GpuCompare.Never),
            maxLod = 1000,
        };
        VkSampler handle;
        Vk.vkCreateSampler(context.Handle, &info, null, &handle).Check("Creating a sampler");
        Handle = handle;
    }

    /// <summary>What it was made from.</summary>
    public GpuSamplerDescription Description { get; }

    internal VkSampler Handle { get; }

    private static VkSamplerAddressMode Address(DeviceContext context, GpuWrap wrap) => wrap switch
    {
        GpuWrap.Clamp => VkSamplerAddressMode.ClampToEdge,
        GpuWrap.Mirror => VkSamplerAddressMode.MirroredRepeat,
        GpuWrap.MirrorOnce when context.Features.MirrorOnce => VkSamplerAddressMode.MirrorClampToEdge,
        GpuWrap.MirrorOnce => throw new GpuException($"Device '{context.Adapter.Name}' cannot wrap textures by MirrorOnce; use Mirror."),
        _ => VkSamplerAddressMode.Repeat,
    };
}
