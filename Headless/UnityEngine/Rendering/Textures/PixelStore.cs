using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The CPU copy of a texture's mip levels and its upload to the GPU.</summary>
internal sealed class PixelStore
{
    private readonly int[] offsets;

    public PixelStore(int width, int height, int depth, GraphicsFormat format, TextureFormat layout, int mipLevels)
    {
        (Width, Height, Depth, Format, Layout, MipLevels) = (width, height, depth, format, layout, mipLevels);
        offsets = new int[mipLevels + 1];
        for (int mip = 0; mip < mipLevels; mip++)
        {
            (int w, int h, int d) = Extent(mip);
            offsets[mip + 1] = checked(offsets[mip] + (w * h * d * PixelCodec.BytesPerPixel(layout)));
        }

        Data = new byte[offsets[mipLevels]];
    }

    public int Width { get; }
    public int Height { get; }
    public int Depth { get; }
    public GraphicsFormat Format { get; }
    public TextureFormat Layout { get; }
    public int MipLevels { get; }
    public byte[] Data { get; }
    public int PixelSize => PixelCodec.BytesPerPixel(Layout);

    public static int FullChain(int width, int height, int depth = 1) =>
        1 + (int)MathF.Log2(Math.Max(width, Math.Max(height, depth)));

    public (int Width, int Height, int Depth) Extent(int mip) =>
        (Math.Max(1, Width >> mip), Math.Max(1, Height >> mip), Math.Max(1, Depth >> mip));

    public Span<byte> Mip(int mip) => Data.AsSpan(offsets[mip], offsets[mip + 1] - offsets[mip]);

    public Span<byte> Pixel(int x, int y, int z, int mip)
    {
        (int w, int h, _) = Extent(mip);
        return Mip(mip).Slice(((((z * h) + y) * w) + x) * PixelSize, PixelSize);
    }

    public Color Get(int x, int y, int z, int mip) => PixelCodec.Read(Layout, Pixel(x, y, z, mip));

    public void Set(int x, int y, int z, int mip, Color color) => PixelCodec.Write(Layout, Pixel(x, y, z, mip), color);

    public void Fill(Color color)
    {
        for (int i = 0; i < Data.Length; i += PixelSize)
        {
            PixelCodec.Write(Layout, Data.AsSpan(i, PixelSize), color);
        }
    }

    /// <summary>Box-filters level 0 down the chain, in linear light for sRGB data.</summary>
    public void BuildMips()
    {
        bool srgb = TextureFormats.IsSrgb(Format);
        for (int mip = 1; mip < MipLevels; mip++)
        {
            (int w, int h, int d) = Extent(mip);
            (int pw, int ph, int pd) = Extent(mip - 1);
            for (int z = 0; z < d; z++)
            {
                for (int y = 0; y < h; y++)
                {
                    for (int x = 0; x < w; x++)
                    {
                        Set(x, y, z, mip, Average(mip - 1, x, y, z, pw, ph, pd, srgb));
                    }
                }
            }
        }
    }

    public void Upload(GpuTexture texture, int layer = 0)
    {
        for (int mip = 0; mip < MipLevels; mip++)
        {
            GraphicsDevice.Recorder.UpdateTexture(texture, mip, layer, ToDevice(mip, texture.Description.Format));
        }
    }

    /// <summary>The bytes of a level in the device's layout.</summary>
    private ReadOnlySpan<byte> ToDevice(int mip, GpuFormat format)
    {
        int deviceBytes = TextureFormats.BytesPerTexel(format);
        bool same = deviceBytes == PixelSize && Layout is not (TextureFormat.BGRA32 or TextureFormat.ARGB32 or TextureFormat.Alpha8);
        if (same)
        {
            return Mip(mip);
        }

        TextureFormat target = format switch
        {
            GpuFormat.R8Unorm => TextureFormat.R8,
            GpuFormat.R32Float => TextureFormat.RFloat,
            GpuFormat.R32G32Float => TextureFormat.RGFloat,
            GpuFormat.R32G32B32A32Float => TextureFormat.RGBAFloat,
            GpuFormat.R16G16B16A16Float => TextureFormat.RGBAHalf,
            _ => TextureFormat.RGBA32,
        };
        ReadOnlySpan<byte> source = Mip(mip);
        int count = source.Length / PixelSize;
        var result = new byte[count * deviceBytes];
        for (int i = 0; i < count; i++)
        {
            Color color = PixelCodec.Read(Layout, source.Slice(i * PixelSize, PixelSize));
            PixelCodec.Write(target, result.AsSpan(i * deviceBytes, deviceBytes), color);
        }

        return result;
    }

    private Color Average(int mip, int x, int y, int z, int pw, int ph, int pd, bool srgb)
    {
        var sum = new Vector4();
        for (int i = 0; i < 8; i++)
        {
            int sx = Math.Min(pw - 1, (x * 2) + (i & 1));
            int sy = Math.Min(ph - 1, (y * 2) + ((i >> 1) & 1));
            int sz = Math.Min(pd - 1, (z * 2) + (i >> 2));
            Color c = Get(sx, sy, sz, mip);
            sum += srgb ? (Vector4)c.linear : (Vector4)c;
        }

        Color average = (Color)(sum / 8f);
        return srgb ? average.gamma : average;
    }
}
