using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>What a format is on the device; Bytes of a texel.</summary>
internal readonly record struct FormatInfo(VkFormat Format, int Bytes, ImageFormat Image, VkImageAspectFlags Aspect, bool Integer = false)
{
    /// <summary>Whether texels are fractions from 0 to 1.</summary>
    public bool Normalised => Image is ImageFormat.R8 or ImageFormat.Rg8 or ImageFormat.Rgba8;
}
