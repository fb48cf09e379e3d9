using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>One binding of a stage's descriptor set.</summary>
internal sealed record LayoutEntry(ShaderResource Resource, VkDescriptorType Type, bool Writes, VkImageViewType ViewType)
{
    public int Binding => Resource.Binding;

    /// <summary>Whether the format that the shader names for a RWTexture is the texture's; other kinds name none.</summary>
    public bool FitsFormat(GpuTexture texture) =>
        Type != VkDescriptorType.StorageImage || Resource.Format == ImageFormat.Unknown || Resource.Format == texture.Info.Image;

    public static LayoutEntry From(ShaderResource resource, string shader)
    {
        if (resource.Count != 1)
        {
            throw new GpuException($"Shader '{shader}': '{resource.Name}' is an array of {resource.Count} textures or samplers; declare them one by one.");
        }

        bool writes = resource.Kind is ResourceKind.RWStructuredBuffer or ResourceKind.RWByteAddressBuffer or ResourceKind.RWTexture
            or ResourceKind.Counter;
        VkDescriptorType type = resource.Kind switch
        {
            ResourceKind.ConstantBuffer => VkDescriptorType.UniformBufferDynamic,
            ResourceKind.Texture => VkDescriptorType.SampledImage,
            ResourceKind.RWTexture => VkDescriptorType.StorageImage,
            ResourceKind.Sampler => VkDescriptorType.Sampler,
            _ => VkDescriptorType.StorageBuffer,
        };
        bool image = type is VkDescriptorType.SampledImage or VkDescriptorType.StorageImage;
        return new LayoutEntry(resource, type, writes, image ? View(resource, shader) : default);
    }

    private static VkImageViewType View(ShaderResource resource, string shader) => resource.Dimension switch
    {
        "2D" or "2DMS" => VkImageViewType._2d,
        "3D" => VkImageViewType._3d,
        "Cube" => VkImageViewType.Cube,
        "2DArray" => VkImageViewType._2dArray,
        _ => throw new GpuException($"Shader '{shader}': texture '{resource.Name}' has the dimension '{resource.Dimension}'; 2D, 3D, Cube and 2DArray are supported."),
    };
}
