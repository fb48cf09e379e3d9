using System.Collections.Generic;
using System;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Device samplers for sampler declarations.</summary>
internal static class Samplers
{
    private static readonly Dictionary<GpuSamplerDescription, GpuSampler> Cache = [];

    public static GpuSampler For(in SamplerEntry entry, Texture? owner)
    {
        // Depth is reversed: nearer is greater, so a shadow comparison passes where the reference is at least the stored depth.
        GpuCompare? compare = entry.Comparison ? GpuCompare.GreaterEqual : null;
        GpuSamplerDescription description = entry.TextureId < 0 || owner == null
            ? new GpuSamplerDescription
            {
                Filter = Filter(entry.TextureId < 0 ? entry.Filter : FilterMode.Bilinear),
                WrapU = Wrap(entry.U),
                WrapV = Wrap(entry.V),
                WrapW = Wrap(entry.W),
                Compare = compare,
            }
            : new GpuSamplerDescription
            {
                Filter = Filter(owner.filterMode),
                WrapU = Wrap(owner.wrapModeU),
                WrapV = Wrap(owner.wrapModeV),
                WrapW = Wrap(owner.wrapModeW),
                Anisotropy = Texture.anisotropicFiltering == AnisotropicFiltering.Disable ? 1 : Math.Clamp(owner.anisoLevel, 1, 16),
                MipBias = owner.mipMapBias,
                Compare = compare,
            };
        if (!Cache.TryGetValue(description, out GpuSampler? sampler))
        {
            sampler = GraphicsDevice.Device.CreateSampler(description);
            Cache.Add(description, sampler);
        }

        return sampler;
    }

    public static void Reset() => Cache.Clear();

    private static GpuFilter Filter(FilterMode mode) => mode switch
    {
        FilterMode.Point => GpuFilter.Point,
        FilterMode.Bilinear => GpuFilter.Bilinear,
        _ => GpuFilter.Trilinear,
    };

    private static GpuWrap Wrap(TextureWrapMode mode) => mode switch
    {
        TextureWrapMode.Clamp => GpuWrap.Clamp,
        TextureWrapMode.Mirror => GpuWrap.Mirror,
        TextureWrapMode.MirrorOnce => GpuWrap.MirrorOnce,
        _ => GpuWrap.Repeat,
    };
}
