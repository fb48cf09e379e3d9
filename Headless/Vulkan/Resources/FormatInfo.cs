using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>What a format is on the device; Bytes of a texel.</summary>
internal readonly record struct FormatInfo(VkFormat Format, int Bytes, ImageFormat Image, VkImageAspectFlags Aspect, bool Integer = false);
