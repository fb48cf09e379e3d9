using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;

namespace Headless.Player.Output;

/// <summary>Writes an opaque 8-bit RGB image as PNG (ISO/IEC 15948), each row filtered by Up: fast, and small for smooth pictures.</summary>
public static class Png
{
    private static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    public static void Write(Stream stream, int width, int height, ReadOnlySpan<byte> rgba)
    {
        stream.Write(Signature);
        Span<byte> header = stackalloc byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = 8;
        header[9] = 2;
        header[10..].Clear();
        WriteChunk(stream, "IHDR"u8, header);
        WriteChunk(stream, "IDAT"u8, Compress(width, height, rgba));
        WriteChunk(stream, "IEND"u8, []);
    }

    private static byte[] Compress(int width, int height, ReadOnlySpan<byte> rgba)
    {
        using var data = new MemoryStream(width * height);
        using (var zlib = new ZLibStream(data, CompressionLevel.Fastest, leaveOpen: true))
        {
            byte[] previous = new byte[width * 3], row = new byte[width * 3], filtered = new byte[width * 3 + 1];
            filtered[0] = 2;
            for (int y = 0; y < height; y++)
            {
                ReadOnlySpan<byte> source = rgba.Slice(y * width * 4, width * 4);
                for (int x = 0; x < width; x++)
                {
                    row[3 * x] = source[4 * x];
                    row[3 * x + 1] = source[4 * x + 1];
                    row[3 * x + 2] = source[4 * x + 2];
                }
                Subtract(row, previous, filtered.AsSpan(1));
                zlib.Write(filtered);
                (row, previous) = (previous, row);
            }
        }
        return data.ToArray();
    }

    private static void Subtract(byte[] row, byte[] previous, Span<byte> result)
    {
        int i = 0;
        for (; i + Vector<byte>.Count <= row.Length; i += Vector<byte>.Count)
            (new Vector<byte>(row, i) - new Vector<byte>(previous, i)).CopyTo(result[i..]);
        for (; i < row.Length; i++) result[i] = (byte)(row[i] - previous[i]);
    }

    private static readonly uint[] CrcTable = [.. Enumerable.Range(0, 256).Select(n =>
    {
        uint c = (uint)n;
        for (int k = 0; k < 8; k++) c = (c & 1) != 0 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
        return c;
    })];

    private static uint Crc(ReadOnlySpan<byte> type, ReadOnlySpan<byte> data) => ~Crc(Crc(0xFFFFFFFFu, type), data);

    private static uint Crc(uint crc, ReadOnlySpan<byte> bytes)
    {
        foreach (byte value in bytes) crc = CrcTable[(crc ^ value) & 0xFF] ^ (crc >> 8);
        return crc;
    }

    private static void WriteChunk(Stream stream, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data)
    {
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
        stream.Write(number);
        stream.Write(type);
        stream.Write(data);
        BinaryPrimitives.WriteUInt32BigEndian(number, Crc(type, data));
        stream.Write(number);
    }
}
