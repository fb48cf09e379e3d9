using System;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>The texture that stands for the screen; its first row is the top of the picture.</summary>
internal static class ScreenTarget
{
    private static GpuTexture? texture;

    public static int Width { get; private set; } = 640;
    public static int Height { get; private set; } = 480;

    public static GpuTexture Texture => texture ??= GraphicsDevice.Device.CreateTexture(
        new GpuTextureDescription
        {
            Width = Width,
            Height = Height,
            Format = GpuFormat.R8G8B8A8Srgb,
            Usage = TextureUse.RenderTarget | TextureUse.Sampled,
        },
        "Screen");

    public static void Resize(int width, int height)
    {
        if (width <= 0 || height <= 0)
        {
            throw new ArgumentException($"The screen must have at least one pixel, not {width}x{height}.");
        }

        if (width != Width || height != Height)
        {
            texture?.Dispose();
            texture = null;
            (Width, Height) = (width, height);
        }
    }

    /// <summary>Asks for the pixels (RGBA bytes in sRGB, top row first) after all work recorded so far.</summary>
    public static ReadbackTicket RequestPixels() => GraphicsDevice.Device.RequestRead(Texture);

    public static void Reset()
    {
        texture?.Dispose();
        texture = null;
    }
}
