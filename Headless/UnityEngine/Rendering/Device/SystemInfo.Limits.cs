using System.Linq;
using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class SystemInfo
{
    public static int maxTextureSize => Limits.MaxTexture2D;
    public static int maxTexture3DSize => Limits.MaxTexture3D;
    public static int maxTextureArraySlices => Limits.MaxTextureLayers;
    public static int maxCubemapSize => Limits.MaxTexture2D;
    public static int maxAnisotropyLevel => 16;
    public static long maxGraphicsBufferSize => Math.Min(Limits.MaxStorageBufferRange, Limits.MaxAllocationSize);
    public static int maxConstantBufferSize => (int)Math.Min(65536, Limits.MaxUniformBufferRange);
    public static int constantBufferOffsetAlignment => 256;
    public static int maxComputeBufferInputsCompute => Math.Min(128, Limits.MaxStorageBuffersPerStage);
    public static int maxComputeBufferInputsVertex => Math.Min(128, Limits.MaxStorageBuffersPerStage);
    public static int maxComputeBufferInputsFragment => Math.Min(128, Limits.MaxStorageBuffersPerStage);
    public static int maxComputeBufferInputsGeometry => Limits.GeometryShader ? Math.Min(128, Limits.MaxStorageBuffersPerStage) : 0;
    public static int maxComputeBufferInputsDomain => 0;
    public static int maxComputeBufferInputsHull => 0;

    // Direct3D 11 allows groups of at most 1024 threads, 1024 x 1024 x 64.
    public static int maxComputeWorkGroupSize => Math.Min(1024, Limits.MaxComputeGroupInvocations);
    public static int maxComputeWorkGroupSizeX => Math.Min(1024, Limits.MaxComputeGroupSize.X);
    public static int maxComputeWorkGroupSizeY => Math.Min(1024, Limits.MaxComputeGroupSize.Y);
    public static int maxComputeWorkGroupSizeZ => Math.Min(64, Limits.MaxComputeGroupSize.Z);
    public static int supportedRenderTargetCount => Math.Min(8, Limits.MaxColorTargets);
    public static int supportedRandomWriteTargetCount => 8;

    public static GraphicsFormat GetGraphicsFormat(DefaultFormat format) => format switch
    {
        DefaultFormat.HDR => GraphicsFormat.R16G16B16A16_SFloat,
        DefaultFormat.DepthStencil or DefaultFormat.Shadow => GraphicsFormat.D32_SFloat,
        _ => GraphicsFormat.R8G8B8A8_SRGB,
    };

    public static bool SupportsRenderTextureFormat(RenderTextureFormat format) => TextureFormats.Supports(format);

    public static bool SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat format) =>
        TextureFormats.Supports(format) && format is not (RenderTextureFormat.Depth or RenderTextureFormat.Shadowmap);

    public static bool SupportsBlendingOnRenderTextureFormat(RenderTextureFormat format) =>
        TextureFormats.Supports(format) && format is not (RenderTextureFormat.Depth or RenderTextureFormat.Shadowmap or RenderTextureFormat.RInt);

    public static bool SupportsTextureFormat(TextureFormat format)
    {
        try
        {
            return TextureFormats.Device(TextureFormats.Of(format, true)) != GpuFormat.None;
        }
        catch (NotSupportedException)
        {
            return false;
        }
    }

    public static int GetRenderTextureSupportedMSAASampleCount(RenderTextureDescriptor desc)
    {
        int samples = desc.msaaSamples;
        while (samples > 1 && (Limits.SampleCounts & samples) == 0)
        {
            samples /= 2;
        }

        return Math.Max(1, samples);
    }
}
