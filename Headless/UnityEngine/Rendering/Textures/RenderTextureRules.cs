using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What a render texture's description must fulfil.</summary>
internal static class RenderTextureRules
{
    public static void Check(in RenderTextureDescriptor d)
    {
        int limit = d.dimension == TextureDimension.Tex3D ? SystemInfo.maxTexture3DSize : SystemInfo.maxTextureSize;
        if (d.width <= 0 || d.height <= 0 || d.width > limit || d.height > limit)
        {
            throw new ArgumentException($"RenderTextureDesc: width and height must be between 1 and {limit}, not {d.width}x{d.height}.");
        }

        if (d.volumeDepth <= 0 || (d.dimension == TextureDimension.Tex3D && d.volumeDepth > limit))
        {
            throw new ArgumentException($"RenderTextureDesc: volumeDepth must be between 1 and {limit}, not {d.volumeDepth}.");
        }

        if (d.msaaSamples is not (1 or 2 or 4 or 8))
        {
            throw new ArgumentException($"RenderTextureDesc: msaaSamples must be 1, 2, 4, or 8, not {d.msaaSamples}.");
        }

        if (d.graphicsFormat == GraphicsFormat.None && d.depthBufferBits == 0)
        {
            throw new ArgumentException("RenderTextureDesc: a render texture needs a color format or a depth buffer.");
        }

        if (d.graphicsFormat != GraphicsFormat.None && TextureFormats.Device(d.graphicsFormat) == Headless.Vulkan.GpuFormat.None)
        {
            throw new NotSupportedException($"RenderTextureDesc: graphics format {d.graphicsFormat} is not supported on this device.");
        }
    }
}
