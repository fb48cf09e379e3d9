using System.IO;

namespace Headless.Engine;

/// <summary>A PNG header that this reader can read.</summary>
internal readonly record struct PngFormat
{
    /// <summary>Largest texture of Direct3D 11.</summary>
    private const int LargestSide = 16384;

    private const int MostPixels = 1 << 26;

    public PngFormat(int width, int height, int depth, int colorType, int interlace)
    {
        if (width <= 0 || height <= 0)
        {
            throw new InvalidDataException($"The PNG file says {width}x{height} pixels.");
        }

        if (width > LargestSide || height > LargestSide || (long)width * height > MostPixels)
        {
            throw new InvalidDataException($"The PNG file says {width}x{height} pixels; textures have at most {LargestSide} a side and {MostPixels} in all.");
        }

        if (interlace != 0)
        {
            throw new InvalidDataException("Interlaced PNG files can't be read: save the image without interlacing.");
        }

        if (depth is not (8 or 16) && colorType is not (0 or 3))
        {
            throw new InvalidDataException($"PNG files with {depth} bits of color type {colorType} can't be read.");
        }

        (Width, Height, Depth, ColorType) = (width, height, depth, colorType);
    }

    public int Width { get; }
    public int Height { get; }
    public int Depth { get; }
    public int ColorType { get; }

    public int Channels => ColorType switch
    {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };

    public bool HasAlpha => ColorType is 4 or 6;
    public int BitsPerPixel => Channels * Depth;
    public int Stride => ((Width * BitsPerPixel) + 7) / 8;
}
