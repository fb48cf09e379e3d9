using System.Buffers.Binary;
using System.IO.Compression;
using System.IO;
using System.Linq;
using System;

namespace Headless.Engine;

/// <summary>Writes PNG files of 1 to 4 channels with 8 bits each.</summary>
internal static class PngWriter
{
    /// <param name="pixels">Rows from the top, channels interleaved.</param>
    public static byte[] Encode(int width, int height, int channels, ReadOnlySpan<byte> pixels, CompressionLevel level = CompressionLevel.Fastest)
    {
        int stride = width * channels;
        if (width <= 0 || height <= 0 || channels is < 1 or > 4 || pixels.Length < stride * height)
        {
            throw new ArgumentException($"{pixels.Length} bytes are no image of {width}x{height} pixels with {channels} channels.");
        }

        using var file = new MemoryStream();
        file.Write(PngChunks.Signature);
        Span<byte> header = stackalloc byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = 8;
        header[9] = (byte)(channels switch { 1 => 0, 2 => 4, 3 => 2, _ => 6 });
        header[10..].Clear();
        PngChunks.Write(file, "IHDR", header);

        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, level, true))
        {
            var line = new byte[stride + 1];
            for (int y = 0; y < height; y++)
            {
                ReadOnlySpan<byte> row = pixels.Slice(y * stride, stride);
                if (y == 0)
                {
                    line[0] = 0;
                    row.CopyTo(line.AsSpan(1));
                }
                else
                {
                    // Filter 2, Up: the difference to the row above.
                    line[0] = 2;
                    ReadOnlySpan<byte> above = pixels.Slice((y - 1) * stride, stride);
                    for (int i = 0; i < stride; i++)
                    {
                        line[i + 1] = (byte)(row[i] - above[i]);
                    }
                }

                zlib.Write(line);
            }
        }

        PngChunks.Write(file, "IDAT", packed.GetBuffer().AsSpan(0, (int)packed.Length));
        PngChunks.Write(file, "IEND", []);
        return file.ToArray();
    }
}
