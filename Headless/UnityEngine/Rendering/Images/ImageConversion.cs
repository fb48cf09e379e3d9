using System;
using Headless.Engine;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine;

public static class ImageConversion
{
    /// <summary>RGB for formats without alpha, otherwise RGBA; row 0 of the texture is the bottom of the picture.</summary>
    public static byte[] EncodeToPNG(this Texture2D tex)
    {
        ArgumentNullException.ThrowIfNull(tex);
        int channels = tex.format is TextureFormat.RGB24 or TextureFormat.R8 or TextureFormat.RHalf or TextureFormat.RFloat ? 3 : 4;
        var pixels = new byte[tex.width * tex.height * channels];
        PixelStore store = tex.Pixels;
        for (int y = 0; y < tex.height; y++)
        {
            for (int x = 0; x < tex.width; x++)
            {
                Color32 c = store.Get(x, tex.height - 1 - y, 0, 0);
                Span<byte> target = pixels.AsSpan(((y * tex.width) + x) * channels, channels);
                (target[0], target[1], target[2]) = (c.r, c.g, c.b);
                if (channels == 4)
                {
                    target[3] = c.a;
                }
            }
        }

        return PngWriter.Encode(tex.width, tex.height, channels, pixels);
    }

    /// <summary>Encodes rows of 8-bit channels as they are stored, row 0 at the bottom.</summary>
    public static byte[] EncodeArrayToPNG(Array array, GraphicsFormat format, uint width, uint height, uint rowBytes = 0)
    {
        ArgumentNullException.ThrowIfNull(array);
        int channels = format switch
        {
            GraphicsFormat.R8_UNorm or GraphicsFormat.R8_SRGB => 1,
            GraphicsFormat.R8G8B8_UNorm or GraphicsFormat.R8G8B8_SRGB => 3,
            GraphicsFormat.R8G8B8A8_UNorm or GraphicsFormat.R8G8B8A8_SRGB => 4,
            _ => throw new ArgumentException($"EncodeArrayToPNG: format {format} can't be encoded: pass 8-bit R, RGB or RGBA.", nameof(format)),
        };
        int stride = (int)width * channels;
        int source = rowBytes > 0 ? (int)rowBytes : stride;
        Span<byte> bytes = ArrayBytes.Of(array, 0, array.Length);
        var pixels = new byte[stride * (int)height];
        for (int y = 0; y < height; y++)
        {
            bytes.Slice(((int)height - 1 - y) * source, stride).CopyTo(pixels.AsSpan(y * stride));
        }

        return PngWriter.Encode((int)width, (int)height, channels, pixels);
    }

    public static bool LoadImage(this Texture2D tex, byte[] data) => LoadImage(tex, data, false);

    /// <summary>Replaces size and content by those of a PNG file; false, with the texture unchanged, for other data.</summary>
    public static bool LoadImage(this Texture2D tex, byte[] data, bool markNonReadable)
    {
        ArgumentNullException.ThrowIfNull(tex);
        if (data is null || !PngReader.IsPng(data))
        {
            return false;
        }

        (int width, int height, byte[] pixels, bool alpha) = PngReader.Decode(data);
        tex.Reinitialize(width, height, alpha ? TextureFormat.RGBA32 : TextureFormat.RGB24, tex.mipmapCount > 1);
        PixelStore store = tex.Pixels;
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                pixels.AsSpan((((height - 1 - y) * width) + x) * 4, store.PixelSize).CopyTo(store.Pixel(x, y, 0, 0));
            }
        }

        tex.Apply(true, markNonReadable);
        return true;
    }
}
