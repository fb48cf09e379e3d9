using System.Buffers.Binary;
using System.IO.Compression;
using System.IO;
using System.Linq;
using System.Text;
using System;

namespace Headless.Engine;

/// <summary>Reads PNG files that are not interlaced: gray, color and palette, 8 and 16 bits a channel, palettes from 1 bit.</summary>
internal static class PngReader
{
    public static bool IsPng(ReadOnlySpan<byte> file) => file.StartsWith(PngChunks.Signature);

    /// <returns>RGBA bytes, rows from the top, and whether the file has an alpha channel.</returns>
    public static (int Width, int Height, byte[] Pixels, bool Alpha) Decode(ReadOnlySpan<byte> file)
    {
        if (!IsPng(file))
        {
            throw new InvalidDataException("This is no PNG file.");
        }

        ReadOnlySpan<byte> header = default;
        byte[] palette = [];
        byte[] transparency = [];
        using var packed = new MemoryStream();
        int position = 8;
        while (position + 12 <= file.Length)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file[position..]);
            if (length < 0 || position + 12 + (long)length > file.Length)
            {
                throw new InvalidDataException("The PNG file ends within a chunk.");
            }

            ReadOnlySpan<byte> data = file.Slice(position + 8, length);
            switch (Encoding.ASCII.GetString(file.Slice(position + 4, 4)))
            {
                case "IHDR":
                    header = data;
                    break;
                case "PLTE":
                    palette = data.ToArray();
                    break;
                case "tRNS":
                    transparency = data.ToArray();
                    break;
                case "IDAT":
                    packed.Write(data);
                    break;
            }

            position += 12 + length;
        }

        if (header.Length < 13)
        {
            throw new InvalidDataException("The PNG file has no header.");
        }

        var format = new PngFormat(
            BinaryPrimitives.ReadInt32BigEndian(header), BinaryPrimitives.ReadInt32BigEndian(header[4..]), header[8], header[9], header[12]);
        packed.Position = 0;
        byte[] rows = Unfilter(packed, format);
        return (format.Width, format.Height, PngPixels.ToRgba(rows, format, palette, transparency), format.HasAlpha || transparency.Length > 0);
    }

    private static byte[] Unfilter(MemoryStream packed, PngFormat format)
    {
        int stride = format.Stride;
        // Deflate packs at most 1032 bytes into one.
        if ((long)stride * format.Height > 1032L * packed.Length) throw new InvalidDataException("The PNG file has too little data for its size.");
        var rows = new byte[stride * format.Height];
        using var zlib = new ZLibStream(packed, CompressionMode.Decompress);
        var previous = new byte[stride];
        int step = Math.Max(1, format.BitsPerPixel / 8);
        for (int y = 0; y < format.Height; y++)
        {
            int filter = zlib.ReadByte();
            Span<byte> row = rows.AsSpan(y * stride, stride);
            zlib.ReadExactly(row);
            for (int i = 0; i < stride; i++)
            {
                int left = i >= step ? row[i - step] : 0;
                int up = previous[i];
                int corner = i >= step ? previous[i - step] : 0;
                row[i] += (byte)(filter switch
                {
                    0 => 0,
                    1 => left,
                    2 => up,
                    3 => (left + up) / 2,
                    4 => Paeth(left, up, corner),
                    _ => throw new InvalidDataException($"Row {y} of the PNG file has the unknown filter {filter}."),
                });
            }

            row.CopyTo(previous);
        }

        return rows;
    }

    private static int Paeth(int left, int up, int corner)
    {
        int estimate = left + up - corner;
        int a = Math.Abs(estimate - left);
        int b = Math.Abs(estimate - up);
        int c = Math.Abs(estimate - corner);
        return a <= b && a <= c ? left : b <= c ? up : corner;
    }
}
