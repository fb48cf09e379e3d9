using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>PLY files of every kind, read back; and those that are none.</summary>
    public sealed class PlyDecoderTests
    {
        private static readonly string[] Formats = { "ascii", "binary_little_endian", "binary_big_endian" };
        private static readonly int[] Counts = { 0, 1, 2, 257, 1009 };

        [Test]
        public void ParticlesAreReadAsTheyWereWritten([ValueSource(nameof(Formats))] string format, [ValueSource(nameof(Counts))] int count)
        {
            FluidParticle[] written = Particles(count);
            Check(SequenceFiles.Ply(written, format), written, true, true);
        }

        [Test]
        public void PropertiesMayStandInAnyOrderAmongOthersAndBeOfAnyType([ValueSource(nameof(Formats))] string format)
        {
            string[] properties = { "uchar red", "uint32 id", "double z", "float64 vx", "short mark", "float32 x", "float vz", "int8 sign",
                "double y", "ushort rank", "float vy", "int part" };
            FluidParticle[] written = Particles(257);
            Check(SequenceFiles.Ply(written, format, properties), written, true, true);
        }

        [Test]
        public void WholeNumbersAreReadOfEveryType([Values("char", "uchar", "short", "ushort", "int", "uint", "float",
            "double")] string type, [ValueSource(nameof(Formats))] string format)
        {
            var written = new[] { new FluidParticle(new Vector3(1f, 2f, 3f), Vector3.zero, 7u),
                new FluidParticle(new Vector3(100f, 0f, 99f), Vector3.zero, 101u) };
            Check(SequenceFiles.Ply(written, format, new[] { type + " x", type + " y", type + " z", type + " id" }), written, false, true);
        }

        [Test]
        public void WithoutVelocitiesAndNumbersTheyRestAndAreCounted([ValueSource(nameof(Formats))] string format)
        {
            FluidParticle[] written = Particles(31).Select((p, i) => new FluidParticle(p.Position, Vector3.zero, (uint)i)).ToArray();
            Check(SequenceFiles.Ply(written, format, new[] { "float x", "float y", "float z" }), written, false, false);
        }

        [Test]
        public void OtherElementsArePassedOver()
        {
            FluidParticle[] written = Particles(17);
            byte[] rows = { 1, 2, 3, 4, 2, 9, 0, 9, 0, 0 }; // two cells of two bytes; two faces with a list each, the second empty
            const string before =
                "comment by hand\nelement cell 2\nproperty uchar a\nproperty uchar b\nelement face 2\nproperty list uchar ushort corners\n";
            byte[] file = SequenceFiles.Ply(written, "binary_little_endian", null, before, rows);
            Check(file, written, true, true);
            byte[] text = SequenceFiles.Ply(written, "ascii", null, before, Encoding.ASCII.GetBytes("1 2\n3 4\n2 9 9\n0\n"));
            Check(text, written, true, true);
            byte[] behind = Insert(SequenceFiles.Ply(written), "end_header", "element face 1\nproperty list uchar int corners\n");
            Check(behind.Concat(new byte[] { 0 }).ToArray(), written, true, true);
        }

        [Test]
        public void LinesMayEndAsOnWindows()
        {
            FluidParticle[] written = Particles(5);
            string text = Encoding.ASCII.GetString(SequenceFiles.Ply(written, "ascii")).Replace("\n", "\r\n");
            Check(Encoding.ASCII.GetBytes(text), written, true, true);
        }

        [Test]
        public void AFileIsRefusedWhereverItIsCut([ValueSource(nameof(Formats))] string format)
        {
            byte[] whole = SequenceFiles.Ply(Particles(3), format);
            for (int length = 0; length < whole.Length - (format == "ascii" ? 2 : 0); length++)
            {
                var cut = new byte[length];
                Array.Copy(whole, cut, length);
                // A text that ends within its last number is a text with another number.
                if (format == "ascii" && length > Array.LastIndexOf(whole, (byte)' ')) break;
                Assert.That(() => Decode(cut, out _), Throws.TypeOf<SequenceException>(), $"{length} of {whole.Length} bytes");
            }
        }

        [TestCase("ply\nformat ascii 1.0\nend_header\n", "no element vertex")]
        [TestCase("ply\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
            "header that cannot be read")]
        [TestCase("ply\nformat gif 1.0\nelement vertex 0\nend_header\n", "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nend_header\n", "without x, y and z")]
        [TestCase(
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nproperty float " +
            "vx\nend_header\n", "not all")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 0\nproperty list uchar float x\nend_header\n", "lists")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 4294967296\nend_header\n", "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\nend_header\n",
            "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nproperty float x\nend_header\n", "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "header that cannot be read")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\n", "header that cannot be read")]
        [TestCase("solid ascii\n", "no PLY file")]
        [TestCase("", "no PLY file")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 two 3\n",
            "text where")]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3 4\n",
            "goes on behind")]
        [TestCase(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty int " +
            "id\nend_header\n1 2 3 -4\n", "the id -4")]
        [TestCase(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float " +
            "id\nend_header\n1 2 3 4.5\n", "the id 4.5")]
        public void WhatIsNoneOrNotWholeIsNamed(string file, string expected)
        {
            var exception = Assert.Throws<SequenceException>(() => Decode(Encoding.ASCII.GetBytes(file), out _));
            Assert.That(exception.Message, Does.Contain(expected));
            Assert.That(exception.Cure, Is.Not.Empty);
        }

        [Test]
        public void BytesBehindTheLastParticleAreNamed()
        {
            byte[] file = SequenceFiles.Ply(Particles(3)).Concat(new byte[] { 0 }).ToArray();
            Assert.That(() => Decode(file, out _), Throws.TypeOf<SequenceException>().With.Message.Contains("goes on behind"));
        }

        [Test]
        public void AHeaderThatNeverEndsIsLeftAfterSixtyFourKilobytes()
        {
            byte[] file =
                Encoding.ASCII.GetBytes("ply\nformat ascii 1.0\n" + string.Concat(Enumerable.Repeat("comment on and on\n", 10000)));
            Assert.That(() => new PlyHeader().Read(file), Throws.TypeOf<SequenceException>());
        }

        [Test]
        public void ReadingAgainMakesNoGarbage()
        {
            var header = new PlyHeader();
            foreach (string format in Formats)
            {
                byte[] file = SequenceFiles.Ply(Particles(257), format);
                var particles = new StoredParticle[257];
                long made = long.MaxValue;
                for (int turn = 0; turn < 3; turn++)
                {
                    long before = GC.GetAllocatedBytesForCurrentThread();
                    header.Read(file);
                    PlyDecoder.Decode(file, header, particles);
                    ParticleIds.Sort(particles);
                    made = Math.Min(made, GC.GetAllocatedBytesForCurrentThread() - before);
                }
                Assert.That(made, Is.Zero, format);
            }
        }

        [Test]
        public void ParticlesAreSortedByTheirNumbers([ValueSource(nameof(Counts))] int count)
        {
            var random = new System.Random(3);
            StoredParticle[] particles = Enumerable.Range(0, count)
                .Select(i => new StoredParticle { Id = (uint)(3 * i), Position = new Vector3(i, 0f, 0f) })
                .OrderBy(_ => random.Next()).ToArray();
            ParticleIds.Sort(particles);
            for (int i = 0; i < count; i++) Assert.That((particles[i].Id, particles[i].Position.x), Is.EqualTo(((uint)(3 * i), (float)i)));
        }

        [Test]
        public void TwoParticlesWithOneNumberAreNamed()
        {
            var particles = new[] { new StoredParticle { Id = 5 }, new StoredParticle { Id = 3 }, new StoredParticle { Id = 5 } };
            Assert.That(() => ParticleIds.Sort(particles), Throws.TypeOf<SequenceException>().With.Message.Contains("the id 5"));
        }

        private static FluidParticle[] Particles(int count) => ParticleSets.Random(count, new Vector3(1f, 2f, 3f), 4f, 11)
            .Select((p, i) => new FluidParticle(p.Position, p.VelT0, (uint)(7 * i + 3))).ToArray();

        private static StoredParticle[] Decode(byte[] file, out PlyHeader header)
        {
            header = new PlyHeader();
            header.Read(file);
            var particles = new StoredParticle[Math.Min(header.Vertex.Count, 100000)];
            PlyDecoder.Decode(file, header, particles);
            return particles;
        }

        private static byte[] Insert(byte[] file, string before, string text)
        {
            int at = Encoding.ASCII.GetString(file).IndexOf(before, StringComparison.Ordinal);
            return file.Take(at).Concat(Encoding.ASCII.GetBytes(text)).Concat(file.Skip(at)).ToArray();
        }

        private static void Check(byte[] file, IReadOnlyList<FluidParticle> written, bool hasVelocities, bool hasIds)
        {
            StoredParticle[] read = Decode(file, out PlyHeader header);
            Assert.That((header.HasVelocities, header.HasIds, read.Length), Is.EqualTo((hasVelocities, hasIds, written.Count)));
            for (int i = 0; i < read.Length; i++)
            {
                Assert.That(read[i].Position.Equals(written[i].Position), $"position of {i}: {read[i].Position} for {written[i].Position}");
                Assert.That(read[i].Velocity.Equals(written[i].VelT0), $"velocity of {i}");
                Assert.That(read[i].Id, Is.EqualTo(written[i].Id));
            }
        }
    }
}
