using System.Buffers.Binary;
using System.IO.Compression;

namespace Headless.Tests.Player;

/// <summary>Reads the 8-bit RGB PNG files that the player writes.</summary>
internal sealed class Picture
{
    private readonly byte[] rgb;

    private Picture(int width, int height, byte[] rgb) => (Width, Height, this.rgb) = (width, height, rgb);

    public int Width { get; }
    public int Height { get; }

    /// <summary>Top left is (0, 0).</summary>
    public (int R, int G, int B) this[int x, int y] => (rgb[3 * (y * Width + x)], rgb[3 * (y * Width + x) + 1], rgb[3 * (y * Width + x) + 2]);

    public static Picture Read(string path) => Read(File.ReadAllBytes(path));

    public static Picture Read(ReadOnlySpan<byte> file)
    {
        int width = 0, height = 0;
        var data = new MemoryStream();
        for (int at = 8; at < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file[at..]);
            ReadOnlySpan<byte> type = file.Slice(at + 4, 4), body = file.Slice(at + 8, length);
            if (type.SequenceEqual("IHDR"u8)) (width, height) = (BinaryPrimitives.ReadInt32BigEndian(body), BinaryPrimitives.ReadInt32BigEndian(body[4..]));
            if (type.SequenceEqual("IDAT"u8)) data.Write(body);
            at += length + 12;
        }
        data.Position = 0;
        var rows = new byte[height * (3 * width + 1)];
        using (var zlib = new ZLibStream(data, CompressionMode.Decompress)) zlib.ReadExactly(rows);
        return new Picture(width, height, Unfilter(rows, width, height));
    }

    private static byte[] Unfilter(byte[] rows, int width, int height)
    {
        int stride = 3 * width;
        var pixels = new byte[height * stride];
        for (int y = 0; y < height; y++)
            for (int i = 0; i < stride; i++)
            {
                int up = rows[y * (stride + 1)] switch
                {
                    0 => 0,
                    2 => y > 0 ? pixels[(y - 1) * stride + i] : 0,
                    var filter => throw new InvalidDataException($"PNG filter {filter} is not read by the tests."),
                };
                pixels[y * stride + i] = (byte)(rows[y * (stride + 1) + 1 + i] + up);
            }
        return pixels;
    }
}
