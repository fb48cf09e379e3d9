using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;

namespace SphFluid
{
    /// <summary>
    /// Tables as NumPy reads them: format version 1.0 of numpy.lib.format, a structured type without gaps, little endian. The header's
    /// length is a multiple of 64 bytes, so that the rows can be mapped into memory.
    /// </summary>
    internal static class NpyFile
    {
        private const int Alignment = 64;
        private const int RowsAtOnce = 1 << 16;

        private static readonly byte[] Magic = { 0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0 };

        /// <summary>Writes a table.</summary>
        /// <param name="stream">Receives it.</param>
        /// <param name="columns">Name and type of each, as "x &lt;f4"; in the order in which they lie in a row.</param>
        /// <param name="rows">The rows, as they lie in memory.</param>
        public static void Write<T>(Stream stream, IReadOnlyList<string> columns, T[] rows) where T : unmanaged
        {
            if (!BitConverter.IsLittleEndian)
            {
                throw new PlatformNotSupportedException("NPY files are written on little-endian machines only.");
            }
            stream.Write(Header(columns, rows.Length));
            for (int first = 0; first < rows.Length; first += RowsAtOnce)
            {
                stream.Write(MemoryMarshal.AsBytes(new ReadOnlySpan<T>(rows, first, Math.Min(RowsAtOnce, rows.Length - first))));
            }
        }

        private static byte[] Header(IReadOnlyList<string> columns, int rows)
        {
            string types = string.Join(", ", columns.Select(c => c.Split(' ')).Select(c => $"('{c[0]}', '{c[1]}')"));
            string text = $"{{'descr': [{types}], 'fortran_order': False, 'shape': ({rows},), }}";
            int before = Magic.Length + sizeof(ushort);
            int length = (before + text.Length + Alignment) / Alignment * Alignment - before;
            var header = new MemoryStream();
            header.Write(Magic);
            header.WriteByte((byte)length);
            header.WriteByte((byte)(length >> 8));
            header.Write(Encoding.ASCII.GetBytes(text.PadRight(length - 1) + "\n"));
            return header.ToArray();
        }
    }
}
