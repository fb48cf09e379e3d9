using System;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Reads drawn pixels back to the CPU.</summary>
internal static class TextureReader
{
    /// <summary>Copies a rectangle (origin bottom left) of the active render texture, or of the screen, into a CPU texture.</summary>
    public static void ReadPixels(Rect source, PixelStore target, int destX, int destY, string owner)
    {
        Texture? active = RenderTexture.active;
        GpuTexture texture = active != null ? active.DeviceTexture(RenderTextureSubElement.Color)! : ScreenTarget.Texture;
        bool bottomFirst = active != null;
        int width = (int)source.width;
        int height = (int)source.height;
        int x0 = (int)source.x;
        int y0 = (int)source.y;
        if (x0 < 0 || y0 < 0 || x0 + width > texture.Description.Width || y0 + height > texture.Description.Height
            || destX < 0 || destY < 0 || destX + width > target.Width || destY + height > target.Height)
        {
            throw new ArgumentException(
                $"Trying to read pixels out of bounds: {source} of a target of {texture.Description.Width}x{texture.Description.Height} into texture '{owner}' of {target.Width}x{target.Height} at ({destX}, {destY}).");
        }

        byte[] bytes = GraphicsDevice.Device.ReadTexture(texture);
        TextureFormat layout = Layout(texture.Description.Format);
        int size = PixelCodec.BytesPerPixel(layout);
        bool same = layout == target.Layout;
        for (int y = 0; y < height; y++)
        {
            int row = bottomFirst ? y0 + y : texture.Description.Height - 1 - (y0 + y);
            ReadOnlySpan<byte> line = bytes.AsSpan(((row * texture.Description.Width) + x0) * size, width * size);
            for (int x = 0; x < width; x++)
            {
                Span<byte> pixel = target.Pixel(destX + x, destY + y, 0, 0);
                if (same)
                {
                    line.Slice(x * size, size).CopyTo(pixel);
                }
                else
                {
                    PixelCodec.Write(target.Layout, pixel, PixelCodec.Read(layout, line.Slice(x * size, size)));
                }
            }
        }
    }

    public static TextureFormat Layout(GpuFormat format) => format switch
    {
        GpuFormat.R8Unorm => TextureFormat.R8,
        GpuFormat.R8G8Unorm => TextureFormat.RG16,
        GpuFormat.R16Float => TextureFormat.RHalf,
        GpuFormat.R16G16Float => TextureFormat.RGHalf,
        GpuFormat.R16G16B16A16Float => TextureFormat.RGBAHalf,
        GpuFormat.R32Float or GpuFormat.D32Float => TextureFormat.RFloat,
        GpuFormat.R32G32Float => TextureFormat.RGFloat,
        GpuFormat.R32G32B32A32Float => TextureFormat.RGBAFloat,
        _ => TextureFormat.RGBA32,
    };
}
