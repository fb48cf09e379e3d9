using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The container of a save: whole, or refused.</summary>
    public sealed class SaveFileTests
    {
        private static readonly (string name, int size)[] Parts = { ("ABOUT", 0), ("PARTICLE", 1000), ("PACE", 1), ("FLOATS", 2_000_003) };

        private static List<(string name, SaveWriter contents)> Sections((string name, int size)[] parts)
        {
            var random = new System.Random(5);
            var sections = new List<(string, SaveWriter)>();
            foreach ((string name, int size) in parts)
            {
                var bytes = new byte[size];
                random.NextBytes(bytes);
                var writer = new SaveWriter();
                writer.WriteItems(bytes, size);
                sections.Add((name, writer));
            }
            return sections;
        }

        private static byte[] Written(List<(string name, SaveWriter contents)> sections)
        {
            var stream = new MemoryStream();
            SaveFile.Write(stream, sections);
            return stream.ToArray();
        }

        [Test]
        public void IsReadAsItWasWritten()
        {
            List<(string name, SaveWriter contents)> sections = Sections(Parts);
            Dictionary<string, byte[]> read = SaveFile.Read(new Dribble(Written(sections)));
            Assert.That(read.Keys, Is.EquivalentTo(Parts.Select(p => p.name)));
            foreach ((string name, SaveWriter contents) in sections) Assert.That(read[name], Is.EqualTo(contents.Bytes.ToArray()), name);
        }

        [Test]
        public void IsRefusedWhereverItIsCut()
        {
            byte[] whole = Written(Sections(Parts.Take(3).ToArray()));
            for (int length = 0; length < whole.Length; length++)
            {
                Assert.That(() => SaveFile.Read(new MemoryStream(whole, 0, length)), Throws.TypeOf<InvalidDataException>(),
                    $"{length} of {whole.Length} bytes");
            }
        }

        [Test]
        public void IsRefusedWhicheverBitIsAltered()
        {
            byte[] whole = Written(Sections(Parts.Take(3).ToArray()));
            for (int bit = 0; bit < 8 * whole.Length; bit++)
            {
                whole[bit / 8] ^= (byte)(1 << bit % 8);
                Assert.That(() => SaveFile.Read(new MemoryStream(whole)), Throws.TypeOf<InvalidDataException>(), $"bit {bit}");
                whole[bit / 8] ^= (byte)(1 << bit % 8);
            }
        }

        [Test]
        public void ValuesItemsAndTextsComeBackInTheirOrder()
        {
            var writer = new SaveWriter();
            writer.Write(new Vector3(1f, 2f, 3f));
            writer.WriteItems(new[] { 4.5, -6.5, 7.0 }, 2);
            writer.WriteText("Größe/Kiste");
            writer.WritePart(part => part.Write(true));
            writer.WriteKey(null);
            writer.WriteText("Gone:BoxCollider");
            var missing = new List<string>();
            var reader = new SaveReader("TEST", writer.Bytes.ToArray(), missing);
            Assert.That(reader.Read<Vector3>(), Is.EqualTo(new Vector3(1f, 2f, 3f)));
            Assert.That(reader.ReadItems<double>(), Is.EqualTo(new[] { 4.5, -6.5 }));
            Assert.That(reader.ReadText(), Is.EqualTo("Größe/Kiste"));
            Assert.That(reader.ReadPart().Read<bool>());
            var present = new Dictionary<string, int>();
            Assert.That(reader.TryFind(present, out int _), Is.False);
            Assert.That(missing, Is.Empty, "no key");
            Assert.That(reader.TryFind(present, out int _), Is.False);
            Assert.That(missing, Is.EqualTo(new[] { "Gone:BoxCollider" }));
            Assert.That(() => reader.Read<byte>(), Throws.TypeOf<InvalidDataException>().With.Message.Contains("TEST"));
        }

        [Test]
        public void ANumberOfItemsBeyondTheSectionIsRefused([Values(-1, 3, int.MaxValue)] int count)
        {
            var writer = new SaveWriter();
            writer.Write(count);
            writer.Write(0L);
            writer.Write(0L);
            Assert.That(() => new SaveReader("TEST", writer.Bytes.ToArray(), null).ReadItems<long>(),
                Throws.TypeOf<InvalidDataException>());
        }

        [Test]
        public void ChecksAndHashesAreThoseOfTheirStandards()
        {
            Assert.That(Crc32.Compute(Encoding.ASCII.GetBytes("123456789")), Is.EqualTo(0xCBF43926u));
            Assert.That(Crc32.Compute(Encoding.ASCII.GetBytes("6789"), Crc32.Compute(Encoding.ASCII.GetBytes("12345"))),
                Is.EqualTo(0xCBF43926u));
            Assert.That(StateHash.Compute(new ReadOnlySpan<byte>(Encoding.ASCII.GetBytes("a"))), Is.EqualTo(0xAF63DC4C8601EC8Cul));
            Assert.That(StateHash.Compute(new ReadOnlySpan<byte>(Encoding.ASCII.GetBytes("foobar"))), Is.EqualTo(0x85944171F73967E8ul));
        }

        // Gives few bytes at a time, as a network does.
        private sealed class Dribble : MemoryStream
        {
            public Dribble(byte[] bytes) : base(bytes)
            {
            }

            public override int Read(byte[] buffer, int offset, int count) => base.Read(buffer, offset, Math.Min(count, 4093));
        }
    }
}
