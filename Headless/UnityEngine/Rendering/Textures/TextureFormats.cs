using System;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Unity's texture formats and the device's.</summary>
internal static class TextureFormats
{
    public static bool IsSrgb(GraphicsFormat format) => format.ToString().EndsWith("_SRGB", StringComparison.Ordinal);

    public static bool IsDepth(GraphicsFormat format) =>
        format is >= GraphicsFormat.D16_UNorm and <= GraphicsFormat.S8_UInt;

    public static GraphicsFormat WithSrgb(GraphicsFormat format, bool srgb) => format switch
    {
        GraphicsFormat.R8G8B8A8_UNorm when srgb => GraphicsFormat.R8G8B8A8_SRGB,
        GraphicsFormat.R8G8B8A8_SRGB when !srgb => GraphicsFormat.R8G8B8A8_UNorm,
        GraphicsFormat.B8G8R8A8_UNorm when srgb => GraphicsFormat.B8G8R8A8_SRGB,
        GraphicsFormat.B8G8R8A8_SRGB when !srgb => GraphicsFormat.B8G8R8A8_UNorm,
        _ => format,
    };

    /// <summary>The device format; None where there is no counterpart.</summary>
    public static GpuFormat Device(GraphicsFormat format) => format switch
    {
        GraphicsFormat.R8_UNorm or GraphicsFormat.R8_SRGB => GpuFormat.R8Unorm,
        GraphicsFormat.R8G8_UNorm or GraphicsFormat.R8G8_SRGB => GpuFormat.R8G8Unorm,
        GraphicsFormat.R8G8B8_UNorm or GraphicsFormat.R8G8B8A8_UNorm or GraphicsFormat.B8G8R8A8_UNorm => GpuFormat.R8G8B8A8Unorm,
        GraphicsFormat.R8G8B8_SRGB or GraphicsFormat.R8G8B8A8_SRGB or GraphicsFormat.B8G8R8A8_SRGB => GpuFormat.R8G8B8A8Srgb,
        GraphicsFormat.R16_SFloat => GpuFormat.R16Float,
        GraphicsFormat.R16G16_SFloat => GpuFormat.R16G16Float,
        GraphicsFormat.R16G16B16A16_SFloat or GraphicsFormat.B10G11R11_UFloatPack32 or GraphicsFormat.A2B10G10R10_UNormPack32
            => GpuFormat.R16G16B16A16Float,
        GraphicsFormat.R32_SFloat or GraphicsFormat.R16_UNorm => GpuFormat.R32Float,
        GraphicsFormat.R32G32_SFloat or GraphicsFormat.R16G16_UNorm => GpuFormat.R32G32Float,
        GraphicsFormat.R32G32B32A32_SFloat or GraphicsFormat.R16G16B16A16_UNorm => GpuFormat.R32G32B32A32Float,
        GraphicsFormat.R32_UInt => GpuFormat.R32Uint,
        GraphicsFormat.R32_SInt => GpuFormat.R32Sint,
        GraphicsFormat.R32G32_UInt => GpuFormat.R32G32Uint,
        GraphicsFormat.R32G32B32A32_UInt => GpuFormat.R32G32B32A32Uint,
        _ => IsDepth(format) ? GpuFormat.D32Float : GpuFormat.None,
    };

    public static GraphicsFormat Of(TextureFormat format, bool linear) => format switch
    {
        TextureFormat.R8 => GraphicsFormat.R8_UNorm,
        TextureFormat.Alpha8 => GraphicsFormat.R8G8B8A8_UNorm,
        TextureFormat.RG16 => GraphicsFormat.R8G8_UNorm,
        TextureFormat.RGB24 => linear ? GraphicsFormat.R8G8B8_UNorm : GraphicsFormat.R8G8B8_SRGB,
        TextureFormat.RGBA32 or TextureFormat.ARGB32 => linear ? GraphicsFormat.R8G8B8A8_UNorm : GraphicsFormat.R8G8B8A8_SRGB,
        TextureFormat.BGRA32 => linear ? GraphicsFormat.B8G8R8A8_UNorm : GraphicsFormat.B8G8R8A8_SRGB,
        TextureFormat.R16 => GraphicsFormat.R16_UNorm,
        TextureFormat.RG32 => GraphicsFormat.R16G16_UNorm,
        TextureFormat.RGBA64 => GraphicsFormat.R16G16B16A16_UNorm,
        TextureFormat.RHalf => GraphicsFormat.R16_SFloat,
        TextureFormat.RGHalf => GraphicsFormat.R16G16_SFloat,
        TextureFormat.RGBAHalf => GraphicsFormat.R16G16B16A16_SFloat,
        TextureFormat.RFloat => GraphicsFormat.R32_SFloat,
        TextureFormat.RGFloat => GraphicsFormat.R32G32_SFloat,
        TextureFormat.RGBAFloat => GraphicsFormat.R32G32B32A32_SFloat,
        _ => throw new NotSupportedException($"Texture format {format} is not supported on this device: import or convert the texture as RGBA32, RGBAHalf or RGBAFloat."),
    };

    public static TextureFormat ToTextureFormat(GraphicsFormat format) => format switch
    {
        GraphicsFormat.R8_UNorm or GraphicsFormat.R8_SRGB => TextureFormat.R8,
        GraphicsFormat.R8G8_UNorm or GraphicsFormat.R8G8_SRGB => TextureFormat.RG16,
        GraphicsFormat.R8G8B8_UNorm or GraphicsFormat.R8G8B8_SRGB => TextureFormat.RGB24,
        GraphicsFormat.B8G8R8A8_UNorm or GraphicsFormat.B8G8R8A8_SRGB => TextureFormat.BGRA32,
        GraphicsFormat.R16_UNorm => TextureFormat.R16,
        GraphicsFormat.R16G16_UNorm => TextureFormat.RG32,
        GraphicsFormat.R16G16B16A16_UNorm => TextureFormat.RGBA64,
        GraphicsFormat.R16_SFloat => TextureFormat.RHalf,
        GraphicsFormat.R16G16_SFloat => TextureFormat.RGHalf,
        GraphicsFormat.R16G16B16A16_SFloat => TextureFormat.RGBAHalf,
        GraphicsFormat.R32_SFloat => TextureFormat.RFloat,
        GraphicsFormat.R32G32_SFloat => TextureFormat.RGFloat,
        GraphicsFormat.R32G32B32A32_SFloat => TextureFormat.RGBAFloat,
        _ => TextureFormat.RGBA32,
    };

    public static GraphicsFormat Of(RenderTextureFormat format, RenderTextureReadWrite readWrite)
    {
        bool srgb = readWrite != RenderTextureReadWrite.Linear;
        return format switch
        {
            RenderTextureFormat.ARGB32 or RenderTextureFormat.Default or RenderTextureFormat.BGRA32 =>
                srgb ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm,
            RenderTextureFormat.ARGBHalf or RenderTextureFormat.DefaultHDR => GraphicsFormat.R16G16B16A16_SFloat,
            RenderTextureFormat.ARGBFloat => GraphicsFormat.R32G32B32A32_SFloat,
            RenderTextureFormat.RGFloat => GraphicsFormat.R32G32_SFloat,
            RenderTextureFormat.RFloat => GraphicsFormat.R32_SFloat,
            RenderTextureFormat.RGHalf => GraphicsFormat.R16G16_SFloat,
            RenderTextureFormat.RHalf => GraphicsFormat.R16_SFloat,
            RenderTextureFormat.R8 => GraphicsFormat.R8_UNorm,
            RenderTextureFormat.RG16 => GraphicsFormat.R8G8_UNorm,
            RenderTextureFormat.R16 => GraphicsFormat.R16_UNorm,
            RenderTextureFormat.RG32 => GraphicsFormat.R16G16_UNorm,
            RenderTextureFormat.ARGB64 => GraphicsFormat.R16G16B16A16_UNorm,
            RenderTextureFormat.RGB111110Float => GraphicsFormat.B10G11R11_UFloatPack32,
            RenderTextureFormat.ARGB2101010 => GraphicsFormat.A2B10G10R10_UNormPack32,
            RenderTextureFormat.RInt => GraphicsFormat.R32_SInt,
            RenderTextureFormat.Depth or RenderTextureFormat.Shadowmap => GraphicsFormat.None,
            _ => throw new NotSupportedException($"Render texture format {format} is not supported on this device: ask SystemInfo.SupportsRenderTextureFormat first."),
        };
    }

    public static bool Supports(RenderTextureFormat format)
    {
        try
        {
            _ = Of(format, RenderTextureReadWrite.Default);
            return true;
        }
        catch (NotSupportedException)
        {
            return false;
        }
    }

    public static RenderTextureFormat ToRenderTextureFormat(GraphicsFormat format) => format switch
    {
        GraphicsFormat.R16G16B16A16_SFloat => RenderTextureFormat.ARGBHalf,
        GraphicsFormat.R32G32B32A32_SFloat => RenderTextureFormat.ARGBFloat,
        GraphicsFormat.R32G32_SFloat => RenderTextureFormat.RGFloat,
        GraphicsFormat.R32_SFloat => RenderTextureFormat.RFloat,
        GraphicsFormat.R16G16_SFloat => RenderTextureFormat.RGHalf,
        GraphicsFormat.R16_SFloat => RenderTextureFormat.RHalf,
        GraphicsFormat.R8_UNorm => RenderTextureFormat.R8,
        GraphicsFormat.R8G8_UNorm => RenderTextureFormat.RG16,
        GraphicsFormat.R16_UNorm => RenderTextureFormat.R16,
        GraphicsFormat.R16G16_UNorm => RenderTextureFormat.RG32,
        GraphicsFormat.R16G16B16A16_UNorm => RenderTextureFormat.ARGB64,
        GraphicsFormat.B10G11R11_UFloatPack32 => RenderTextureFormat.RGB111110Float,
        GraphicsFormat.A2B10G10R10_UNormPack32 => RenderTextureFormat.ARGB2101010,
        GraphicsFormat.R32_SInt => RenderTextureFormat.RInt,
        GraphicsFormat.None => RenderTextureFormat.Depth,
        _ => RenderTextureFormat.ARGB32,
    };

    public static int BytesPerTexel(GpuFormat format) => format switch
    {
        GpuFormat.R8Unorm => 1,
        GpuFormat.R8G8Unorm or GpuFormat.R16Float => 2,
        GpuFormat.R16G16B16A16Float or GpuFormat.R32G32Float or GpuFormat.R32G32Uint => 8,
        GpuFormat.R32G32B32A32Float or GpuFormat.R32G32B32A32Uint => 16,
        _ => 4,
    };

    public static ImageFormat StorageFormat(GpuFormat format) => format switch
    {
        GpuFormat.R8Unorm => ImageFormat.R8,
        GpuFormat.R8G8Unorm => ImageFormat.Rg8,
        GpuFormat.R8G8B8A8Unorm or GpuFormat.R8G8B8A8Srgb => ImageFormat.Rgba8,
        GpuFormat.R16Float => ImageFormat.R16f,
        GpuFormat.R16G16Float => ImageFormat.Rg16f,
        GpuFormat.R16G16B16A16Float => ImageFormat.Rgba16f,
        GpuFormat.R32Float => ImageFormat.R32f,
        GpuFormat.R32G32Float => ImageFormat.Rg32f,
        GpuFormat.R32G32B32A32Float => ImageFormat.Rgba32f,
        GpuFormat.R32Uint => ImageFormat.R32ui,
        GpuFormat.R32Sint => ImageFormat.R32i,
        GpuFormat.R32G32Uint => ImageFormat.Rg32ui,
        GpuFormat.R32G32B32A32Uint => ImageFormat.Rgba32ui,
        _ => ImageFormat.Unknown,
    };
}
