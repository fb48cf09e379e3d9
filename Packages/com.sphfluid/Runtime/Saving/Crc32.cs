using System;

namespace SphFluid
{
    /// <summary>CRC-32 as ISO 3309 and PNG have it. Worked example: of the ASCII digits 123456789 it is 0xCBF43926.</summary>
    internal static class Crc32
    {
        static readonly uint[] Table = MakeTable();

        /// <summary>The check of bytes that follow others.</summary>
        /// <param name="bytes">The bytes.</param>
        /// <param name="before">The check of those before; 0 where there are none.</param>
        public static uint Of(ReadOnlySpan<byte> bytes, uint before = 0u)
        {
            uint crc = ~before;
            foreach (byte value in bytes) crc = Table[(byte)crc ^ value] ^ crc >> 8;
            return ~crc;
        }

        static uint[] MakeTable()
        {
            var table = new uint[256];
            for (uint i = 0; i < 256u; i++)
            {
                uint entry = i;
                for (int bit = 0; bit < 8; bit++) entry = (entry & 1u) != 0u ? 0xEDB88320u ^ entry >> 1 : entry >> 1;
                table[i] = entry;
            }
            return table;
        }
    }
}
