using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>This layer's formats as Vulkan's and SPIR-V's.</summary>
internal static class FormatTable
{
    private const VkImageAspectFlags Color = VkImageAspectFlags.Color;

    public static FormatInfo Of(GpuFormat format) => format switch
    {
        GpuFormat.R8Unorm => new(VkFormat.R8Unorm, 1, ImageFormat.R8, Color),
        GpuFormat.R8G8Unorm => new(VkFormat.R8g8Unorm, 2, ImageFormat.Rg8, Color),
        GpuFormat.R8G8B8A8Unorm => new(VkFormat.R8g8b8a8Unorm, 4, ImageFormat.Rgba8, Color),
        GpuFormat.R8G8B8A8Srgb => new(VkFormat.R8g8b8a8Srgb, 4, ImageFormat.Rgba8, Color),
        GpuFormat.R16Float => new(VkFormat.R16Sfloat, 2, ImageFormat.R16f, Color),
        GpuFormat.R16G16Float => new(VkFormat.R16g16Sfloat, 4, ImageFormat.Rg16f, Color),
        GpuFormat.R16G16B16A16Float => new(VkFormat.R16g16b16a16Sfloat, 8, ImageFormat.Rgba16f, Color),
        GpuFormat.R32Float => new(VkFormat.R32Sfloat, 4, ImageFormat.R32f, Color),
        GpuFormat.R32G32Float => new(VkFormat.R32g32Sfloat, 8, ImageFormat.Rg32f, Color),
        GpuFormat.R32G32B32A32Float => new(VkFormat.R32g32b32a32Sfloat, 16, ImageFormat.Rgba32f, Color),
        GpuFormat.R32Uint => new(VkFormat.R32Uint, 4, ImageFormat.R32ui, Color, true),
        GpuFormat.R32Sint => new(VkFormat.R32Sint, 4, ImageFormat.R32i, Color, true),
        GpuFormat.R32G32Uint => new(VkFormat.R32g32Uint, 8, ImageFormat.Rg32ui, Color, true),
        GpuFormat.R32G32B32A32Uint => new(VkFormat.R32g32b32a32Uint, 16, ImageFormat.Rgba32ui, Color, true),
        GpuFormat.D32Float => new(VkFormat.D32Sfloat, 4, ImageFormat.Unknown, VkImageAspectFlags.Depth),
        _ => throw new ArgumentOutOfRangeException(nameof(format), format, "Not a texel format."),
    };
}
