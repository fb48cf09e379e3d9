using System;
using System.Buffers.Binary;

namespace SphFluid
{
    /// <summary>
    /// CRC-32 as ISO 3309 and PNG have it, eight bytes at a time (Kounavis and Berry 2005, "A systematic approach to building high
    /// performance, software-based, CRC generators"). Worked example: of the ASCII digits 123456789 it is 0xCBF43926.
    /// </summary>
    internal static class Crc32
    {
        private const int Slices = 8, Entries = 256;

        // Entry i of slice k: the check of byte i with k zero bytes behind it.
        private static readonly uint[] Table = MakeTable();

        /// <summary>The check of bytes that follow others.</summary>
        /// <param name="bytes">The bytes.</param>
        /// <param name="before">The check of those before; 0 where there are none.</param>
        public static uint Compute(ReadOnlySpan<byte> bytes, uint before = 0u)
        {
            uint crc = ~before;
            while (bytes.Length >= Slices)
            {
                uint low = crc ^ BinaryPrimitives.ReadUInt32LittleEndian(bytes),
                    high = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(4));
                crc = At(7, low) ^ At(6, low >> 8) ^ At(5, low >> 16) ^ At(4, low >> 24) ^ At(3, high) ^ At(2, high >> 8) ^
                    At(1, high >> 16) ^ At(0, high >> 24);
                bytes = bytes.Slice(Slices);
            }
            foreach (byte value in bytes) crc = At(0, crc ^ value) ^ crc >> 8;
            return ~crc;
        }

        private static uint At(int slice, uint value) => Table[Entries * slice + (int)(value & 255u)];

        private static uint[] MakeTable()
        {
            var table = new uint[Slices * Entries];
            for (uint i = 0; i < Entries; i++)
            {
                uint entry = i;
                for (int bit = 0; bit < 8; bit++) entry = (entry & 1u) != 0u ? 0xEDB88320u ^ entry >> 1 : entry >> 1;
                table[i] = entry;
            }
            for (int i = Entries; i < table.Length; i++) table[i] = table[i - Entries] >> 8 ^ table[table[i - Entries] & 255u];
            return table;
        }
    }
}
