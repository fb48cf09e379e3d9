using System.Numerics;
using System.Runtime.InteropServices;
using System.Text;

namespace Headless.Importers.Yaml;

/// <summary>
/// xxHash64, seed 0 (Y. Collet, https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md). Model importers derive
/// the file id of a sub-asset from it: <c>Type:Mesh-&gt;default0</c> gives -2432090755550338912.
/// </summary>
public static class XxHash64
{
    private const ulong P1 = 0x9E3779B185EBCA87, P2 = 0xC2B2AE3D27D4EB4F, P3 = 0x165667B19E3779F9, P4 = 0x85EBCA77C2B2AE63, P5 = 0x27D4EB2F165667C5;

    /// <summary>File id of the first sub-asset of this class and name in a model.</summary>
    public static long FileId(string className, string name, int repeat = 0) => unchecked((long)Hash(Encoding.UTF8.GetBytes($"Type:{className}->{name}{repeat}")));

    public static ulong Hash(ReadOnlySpan<byte> data)
    {
        int length = data.Length;
        ulong hash;
        if (length >= 32)
        {
            ulong a = unchecked(P1 + P2), b = P2, c = 0, d = unchecked(0 - P1);
            for (; data.Length >= 32; data = data[32..])
            {
                a = Round(a, Read64(data));
                b = Round(b, Read64(data[8..]));
                c = Round(c, Read64(data[16..]));
                d = Round(d, Read64(data[24..]));
            }
            hash = BitOperations.RotateLeft(a, 1) + BitOperations.RotateLeft(b, 7) + BitOperations.RotateLeft(c, 12) + BitOperations.RotateLeft(d, 18);
            hash = Merge(Merge(Merge(Merge(hash, a), b), c), d);
        }
        else
        {
            hash = P5;
        }
        hash += (ulong)length;
        for (; data.Length >= 8; data = data[8..])
            hash = BitOperations.RotateLeft(hash ^ Round(0, Read64(data)), 27) * P1 + P4;
        if (data.Length >= 4)
        {
            hash = BitOperations.RotateLeft(hash ^ MemoryMarshal.Read<uint>(data) * P1, 23) * P2 + P3;
            data = data[4..];
        }
        foreach (byte value in data) hash = BitOperations.RotateLeft(hash ^ value * P5, 11) * P1;
        hash = (hash ^ hash >> 33) * P2;
        hash = (hash ^ hash >> 29) * P3;
        return hash ^ hash >> 32;
    }

    private static ulong Read64(ReadOnlySpan<byte> data) => MemoryMarshal.Read<ulong>(data);
    private static ulong Round(ulong sum, ulong input) => BitOperations.RotateLeft(sum + input * P2, 31) * P1;
    private static ulong Merge(ulong sum, ulong value) => (sum ^ Round(0, value)) * P1 + P4;
}
