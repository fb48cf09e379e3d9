using System.Buffers.Binary;
using System.Text;

namespace Headless.Shaders.Direct3D;

/// <summary>Chunks of a compiled Direct3D shader: "DXBC", hash, version, size, number of chunks, their offsets.</summary>
internal static class DxbcContainer
{
    private const int CountOffset = 28;
    private const int ChunkHeader = 8;

    /// <summary>Bytes of the chunk with a four-letter name.</summary>
    /// <exception cref="InvalidDataException">No whole container, or no such chunk.</exception>
    public static ReadOnlyMemory<byte> Chunk(ReadOnlyMemory<byte> container, string name)
    {
        try
        {
            ReadOnlySpan<byte> bytes = container.Span;
            if (!bytes.StartsWith("DXBC"u8))
            {
                throw new InvalidDataException("not a Direct3D shader: it does not begin with DXBC");
            }
            int count = Number(bytes, CountOffset);
            for (int i = 0; i < count; i++)
            {
                int start = Number(bytes, CountOffset + 4 + 4 * i);
                if (Encoding.ASCII.GetString(bytes.Slice(start, 4)) == name)
                {
                    return container.Slice(start + ChunkHeader, Number(bytes, start + 4));
                }
            }
        }
        catch (ArgumentOutOfRangeException)
        {
            throw new InvalidDataException("a Direct3D shader that is not whole");
        }
        throw new InvalidDataException($"the Direct3D shader has no chunk {name}");
    }

    private static int Number(ReadOnlySpan<byte> bytes, int at) => BinaryPrimitives.ReadInt32LittleEndian(bytes[at..]);
}
