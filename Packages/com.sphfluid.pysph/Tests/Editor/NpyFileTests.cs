using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>NPY as numpy.lib.format describes version 1.0, byte by byte.</summary>
    public sealed class NpyFileTests
    {
        private static byte[] Bytes(int rows)
        {
            var stream = new MemoryStream();
            NpyFile.Write(stream, LiquidParticle.Columns, Enumerable.Range(0, rows)
                .Select(i => new LiquidParticle
                {
                    Position = new Vector3(1f, 2f, 3f), Velocity = new Vector3(4f, 5f, 6f + i),
                    Id = uint.MaxValue - (uint)i
                }).ToArray());
            return stream.ToArray();
        }

        private static int HeaderLength(byte[] file) => 10 + file[8] + 256 * file[9];

        [Test]
        public void TheHeaderNamesTypeOrderAndShape()
        {
            byte[] file = Bytes(1);

            Assert.That(file.Take(8), Is.EqualTo(new byte[] { 0x93, 0x4E, 0x55, 0x4D, 0x50, 0x59, 1, 0 }));
            string header = Encoding.ASCII.GetString(file, 10, HeaderLength(file) - 10);
            Assert.That(header.TrimEnd(' ', '\n'), Is.EqualTo(
                "{'descr': [('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('u', '<f4'), ('v', '<f4'), ('w', '<f4'), ('id', '<u4')], " +
                "'fortran_order': False, 'shape': (1,), }"));
            Assert.That(header, Does.EndWith("\n"));
        }

        [Test]
        public void RowsBeginAtAMultipleOf64AndHaveNoGaps([Values(0, 1, 2, 9, 10, 65535, 65536, 65537)] int rows)
        {
            byte[] file = Bytes(rows);

            Assert.That(HeaderLength(file) % 64, Is.Zero);
            Assert.That(file.Length, Is.EqualTo(HeaderLength(file) + 28 * rows));
        }

        [Test]
        public void NumbersAreLittleEndianInTheOrderOfTheColumns()
        {
            byte[] row = Bytes(2).Skip(HeaderLength(Bytes(2)) + 28).ToArray();

            Assert.That(row.Take(8), Is.EqualTo(new byte[] { 0, 0, 0x80, 0x3F, 0, 0, 0, 0x40 }), "x = 1, y = 2");
            Assert.That(row.Skip(20), Is.EqualTo(new byte[] { 0, 0, 0xE0, 0x40, 0xFE, 0xFF, 0xFF, 0xFF }), "w = 7, id = 2^32 - 2");
        }
    }
}
