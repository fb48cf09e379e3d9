using System;

namespace Headless.Engine;

/// <summary>Turns the rows of a PNG file into RGBA bytes.</summary>
internal static class PngPixels
{
    public static byte[] ToRgba(byte[] rows, PngFormat format, byte[] palette, byte[] transparency)
    {
        var pixels = new byte[format.Width * format.Height * 4];
        Span<int> channels = stackalloc int[4];
        for (int y = 0; y < format.Height; y++)
        {
            ReadOnlySpan<byte> row = rows.AsSpan(y * format.Stride, format.Stride);
            for (int x = 0; x < format.Width; x++)
            {
                for (int c = 0; c < format.Channels; c++)
                {
                    channels[c] = Sample(row, (x * format.Channels) + c, format.Depth);
                }

                Span<byte> target = pixels.AsSpan(((y * format.Width) + x) * 4, 4);
                target[3] = 255;
                switch (format.ColorType)
                {
                    case 3:
                        int index = channels[0];
                        palette.AsSpan(index * 3, 3).CopyTo(target);
                        target[3] = index < transparency.Length ? transparency[index] : (byte)255;
                        break;
                    case 0 or 4:
                        byte gray = To8(channels[0], format.Depth);
                        (target[0], target[1], target[2]) = (gray, gray, gray);
                        target[3] = format.ColorType == 4 ? To8(channels[1], format.Depth) : (byte)255;
                        break;
                    default:
                        for (int c = 0; c < format.Channels; c++)
                        {
                            target[c] = To8(channels[c], format.Depth);
                        }

                        break;
                }
            }
        }

        return pixels;
    }

    private static int Sample(ReadOnlySpan<byte> row, int index, int depth) => depth switch
    {
        16 => (row[index * 2] << 8) | row[(index * 2) + 1],
        8 => row[index],
        _ => (row[index * depth / 8] >> (8 - depth - (index * depth % 8))) & ((1 << depth) - 1),
    };

    private static byte To8(int value, int depth) => (byte)(depth == 16 ? value >> 8 : value * 255 / ((1 << depth) - 1));
}
