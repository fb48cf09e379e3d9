using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Tables go to NumPy's format and come back bit by bit; what is no such table is named.</summary>
    public sealed class NpyFileTests
    {
        private string file;

        [SetUp]
        public void SetUp() => file = Path.GetTempFileName();

        [TearDown]
        public void TearDown() => File.Delete(file);

        [Test]
        public void ATableComesBack([Values(0, 1, 2, 7, 127)] int rows, [Values(1, 3, 8)] int columns)
        {
            float[,] table = Table(rows, columns);
            NpyFile.Write(file, table);

            Assert.That(NpyFile.Read(file, columns), Is.EqualTo(table));
            Assert.That((new FileInfo(file).Length - sizeof(float) * table.Length) % 64, Is.Zero,
                "numbers begin at a multiple of 64 bytes");
        }

        [Test]
        public void NumbersThatAreNotFiniteComeBack()
        {
            var table = new[,] { { float.NaN, float.PositiveInfinity, float.NegativeInfinity, -0f } };
            NpyFile.Write(file, table);

            float[,] read = NpyFile.Read(file, 4);
            Assert.That(read, Is.EqualTo(table));
            Assert.That(float.IsNegative(read[0, 3]), Is.True);
        }

        [Test]
        public void AFileOfNumPyIsRead()
        {
            // numpy.save(file, numpy.array([[1, 2.5, -3]], dtype='<f4')), NumPy 1.24.2
            string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 3), }".PadRight(117) + "\n";
            byte[] start = { 0x93, 0x4E, 0x55, 0x4D, 0x50, 0x59, 1, 0, 118, 0 },
                numbers = { 0, 0, 0x80, 0x3F, 0, 0, 0x20, 0x40, 0, 0, 0x40, 0xC0 };
            byte[] all = start.Concat(Encoding.ASCII.GetBytes(header)).Concat(numbers).ToArray();
            File.WriteAllBytes(file, all);

            Assert.That(NpyFile.Read(file, 3), Is.EqualTo(new[,] { { 1f, 2.5f, -3f } }));
            NpyFile.Write(file, new[,] { { 1f, 2.5f, -3f } });
            Assert.That(File.ReadAllBytes(file), Is.EqualTo(all), "and written the same");
        }

        [TestCase(0, "no NumPy file")]
        [TestCase(9, "no NumPy file")]
        [TestCase(40, "no table of 3 columns")]
        [TestCase(128, "has 0 bytes of numbers, its header says 84")]
        [TestCase(211, "has 83 bytes of numbers, its header says 84")]
        public void AFileThatWasCutIsNamed(int length, string problem)
        {
            NpyFile.Write(file, Table(7, 3));
            File.WriteAllBytes(file, File.ReadAllBytes(file).Take(length).ToArray());
            Refuses(problem);
        }

        [TestCase("'<f4'", "'<f8'")]
        [TestCase("'<f4'", "'>f4'")]
        [TestCase("False", "True ")]
        [TestCase("(7, 3)", "(7,)  ")]
        [TestCase("(7, 3)", "(3, 7)")]
        public void AnotherTableIsNamed(string from, string to)
        {
            NpyFile.Write(file, Table(7, 3));
            Encoding latin = Encoding.GetEncoding("iso-8859-1");
            File.WriteAllText(file, File.ReadAllText(file, latin).Replace(from, to), latin);
            Refuses("no table of 3 columns");
        }

        [Test]
        public void BytesBehindTheNumbersAreNamed()
        {
            NpyFile.Write(file, Table(7, 3));
            File.WriteAllBytes(file, File.ReadAllBytes(file).Append((byte)0).ToArray());
            Refuses("has 85 bytes of numbers, its header says 84");
        }

        private void Refuses(string problem) =>
            Assert.That(() => NpyFile.Read(file, 3),
                Throws.TypeOf<InvalidDataException>().With.Message.Contains(problem).And.Message.Contains(file));

        private static float[,] Table(int rows, int columns)
        {
            var table = new float[rows, columns];
            for (int r = 0; r < rows; r++)
                for (int c = 0; c < columns; c++) table[r, c] = 1f / (1 + r * columns + c);
            return table;
        }
    }
}
