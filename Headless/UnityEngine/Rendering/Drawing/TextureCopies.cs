using System;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Graphics.CopyTexture: texels of equal size from texture to texture, without a shader.</summary>
internal static class TextureCopies
{
    public static void Copy(Texture? source, Texture? target)
    {
        (GpuTexture from, GpuTexture to) = Pair(source, target);
        int mips = Math.Min(from.Description.MipLevels, to.Description.MipLevels);
        int layers = Math.Min(from.Description.Layers, to.Description.Layers);
        for (int layer = 0; layer < layers; layer++)
        {
            for (int mip = 0; mip < mips; mip++)
            {
                GraphicsDevice.Recorder.CopyTexture(from, mip, layer, to, mip, layer);
            }
        }
    }

    public static void Copy(Texture? source, int sourceElement, int sourceMip, Texture? target, int targetElement, int targetMip)
    {
        (GpuTexture from, GpuTexture to) = Pair(source, target);
        GraphicsDevice.Recorder.CopyTexture(from, sourceMip, sourceElement, to, targetMip, targetElement);
    }

    private static (GpuTexture From, GpuTexture To) Pair(Texture? source, Texture? target)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(target);
        TargetState.Finish();
        GpuTexture? from = source.DeviceTexture(RenderTextureSubElement.Default);
        GpuTexture? to = target.DeviceTexture(RenderTextureSubElement.Default);
        return from is not null && to is not null
            ? (from, to)
            : throw new ArgumentException($"Graphics.CopyTexture: '{source.name}' or '{target.name}' has no texture on the device.");
    }
}
