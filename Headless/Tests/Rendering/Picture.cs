using Headless.Engine;
using UnityEngine;

namespace Headless.Tests.Rendering;

/// <summary>Pixels of a finished picture; (0, 0) is the bottom left.</summary>
public sealed class Picture
{
    private readonly byte[] pixels;

    private Picture(int width, int height, byte[] pixels) => (Width, Height, this.pixels) = (width, height, pixels);

    public int Width { get; }
    public int Height { get; }

    public static Picture OfScreen() =>
        new(ScreenTarget.Width, ScreenTarget.Height, GraphicsDevice.Device.ReadTexture(ScreenTarget.Texture));

    public static Picture Of(RenderTexture texture)
    {
        RenderTexture? active = RenderTexture.active;
        RenderTexture.active = texture;
        var copy = new Texture2D(texture.width, texture.height, TextureFormat.RGBA32, false);
        copy.ReadPixels(new Rect(0, 0, texture.width, texture.height), 0, 0, false);
        RenderTexture.active = active;
        byte[] rows = copy.GetRawTextureData();
        int stride = texture.width * 4;
        var flipped = new byte[rows.Length];
        for (int y = 0; y < texture.height; y++)
        {
            rows.AsSpan(y * stride, stride).CopyTo(flipped.AsSpan((texture.height - 1 - y) * stride));
        }

        return new Picture(texture.width, texture.height, flipped);
    }

    public Color32 At(int x, int y)
    {
        ReadOnlySpan<byte> p = pixels.AsSpan((((Height - 1 - y) * Width) + x) * 4, 4);
        return new Color32(p[0], p[1], p[2], p[3]);
    }

    public Color32 At(Vector3 screenPoint) => At((int)screenPoint.x, (int)screenPoint.y);

    public float Brightness(Vector3 screenPoint)
    {
        Color32 c = At(screenPoint);
        return (c.r + c.g + c.b) / 765f;
    }

    /// <summary>Share of the pixels that fulfil a condition.</summary>
    public float Share(Predicate<Color32> condition)
    {
        int count = 0;
        for (int i = 0; i < Width * Height; i++)
        {
            count += condition(At(i % Width, i / Width)) ? 1 : 0;
        }

        return count / (float)(Width * Height);
    }

    /// <summary>Writes the picture to the folder named by HEADLESS_PICTURES, for a look at it.</summary>
    public Picture Keep(string name)
    {
        if (Environment.GetEnvironmentVariable("HEADLESS_PICTURES") is { Length: > 0 } folder)
        {
            Directory.CreateDirectory(folder);
            File.WriteAllBytes(Path.Combine(folder, name + ".png"), PngWriter.Encode(Width, Height, 4, pixels));
        }

        return this;
    }
}
