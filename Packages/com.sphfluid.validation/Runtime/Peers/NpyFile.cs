using System;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;

namespace SphFluid.Validation
{
    /// <summary>
    /// Tables of single-precision numbers in NumPy's file format, version 1.0 (NEP 1, numpy.org/neps/nep-0001-npy-format.html):
    /// little-endian, row by row. Example: <c>numpy.save(file, table.astype(numpy.float32))</c>.
    /// </summary>
    internal static class NpyFile
    {
        private const int HeaderAlignment = 64, LengthAt = 8, HeaderAt = 10;

        private static readonly byte[] magic = { 0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0 };
        private static readonly Regex shape =
            new Regex(@"'descr': '<f4', 'fortran_order': False, 'shape': \((\d{1,9}), (\d{1,9})\)", RegexOptions.CultureInvariant);

        /// <summary>Writes a table.</summary>
        /// <param name="file">The file.</param>
        /// <param name="table">The numbers, rows first.</param>
        public static void Write(string file, float[,] table)
        {
            string header =
                FormattableString.Invariant($"{{'descr': '<f4', 'fortran_order': False, 'shape': ({table.GetLength(0)}, ") +
                FormattableString.Invariant($"{table.GetLength(1)}), }}");
            int length = (HeaderAt + header.Length + HeaderAlignment) / HeaderAlignment * HeaderAlignment - HeaderAt;
            using (var writer = new BinaryWriter(File.Create(file)))
            {
                writer.Write(magic);
                writer.Write((ushort)length);
                writer.Write(Encoding.ASCII.GetBytes(header.PadRight(length - 1) + "\n"));
                var bytes = new byte[sizeof(float) * table.Length];
                Buffer.BlockCopy(table, 0, bytes, 0, bytes.Length);
                writer.Write(bytes);
            }
        }

        /// <summary>Reads a table.</summary>
        /// <param name="file">The file.</param>
        /// <param name="columns">Numbers that each row must have.</param>
        /// <exception cref="InvalidDataException">It is no such table, or was cut; the message names the file.</exception>
        public static float[,] Read(string file, int columns)
        {
            byte[] bytes = File.ReadAllBytes(file);
            if (bytes.Length < HeaderAt || !bytes.AsSpan(0, magic.Length).SequenceEqual(magic))
            {
                throw new InvalidDataException($"'{file}' is no NumPy file of version 1.0.");
            }
            int begin = HeaderAt + (bytes[LengthAt] | bytes[LengthAt + 1] << 8);
            Match match = shape.Match(Encoding.ASCII.GetString(bytes, HeaderAt, Math.Min(begin, bytes.Length) - HeaderAt));
            if (!match.Success || int.Parse(match.Groups[2].Value) != columns)
            {
                throw new InvalidDataException($"'{file}' is no table of {columns} columns of single precision, row by row.");
            }
            long rows = long.Parse(match.Groups[1].Value), length = sizeof(float) * rows * columns;
            if (bytes.Length - begin != length)
            {
                throw new InvalidDataException($"'{file}' has {bytes.Length - begin} bytes of numbers, its header says {length}.");
            }
            var table = new float[rows, columns];
            Buffer.BlockCopy(bytes, begin, table, 0, (int)length);
            return table;
        }
    }
}
