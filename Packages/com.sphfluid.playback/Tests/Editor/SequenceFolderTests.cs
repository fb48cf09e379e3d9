using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Folders of particle files: what is written is read, and what is wrong is named with a cure.</summary>
    public sealed class SequenceFolderTests
    {
        private static readonly Vector3 Domain = new Vector3(1f, 2f, 3f);
        private static readonly int[] Counts = { 0, 1, 257, 13 };
        private static readonly double[] Times = { 0.0, 0.1, 0.25, 1.0 / 3.0 };

        private SequenceFiles files;

        [SetUp]
        public void SetUp() => files = new SequenceFiles();

        [TearDown]
        public void TearDown() => files.Dispose();

        [Test]
        public void ASequenceIsReadAsItWasWritten()
        {
            WriteSequence();
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 0.0);
            Assert.That(sequence.Frames.Select(f => f.Time), Is.EqualTo(Times));
            Assert.That(sequence.Frames.Select(f => f.Particles), Is.EqualTo(Counts));
            Assert.That((sequence.Spacing, sequence.DomainSize, sequence.Source, sequence.MostParticles),
                Is.EqualTo((0.02f, Domain, "test", 257L)));
            Assert.That((sequence.HasIds, sequence.HasVelocities), Is.EqualTo((true, true)));
            for (int frame = 0; frame < Counts.Length; frame++) CheckFrame(sequence, frame, p => p);
        }

        [Test]
        public void AFolderOfPlyFilesIsPlayedInTheOrderOfItsNumbers()
        {
            foreach (int number in new[] { 10, 9, 100, 2 })
            {
                File.WriteAllBytes(files[$"state-{number}.ply"],
                    SequenceFiles.Ply(Frame(number % 4), number == 9 ? "ascii" : "binary_big_endian"));
            }
            File.WriteAllText(files["notes.txt"], "no frame");
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 20.0);
            Assert.That(sequence.Frames.Select(f => f.Name),
                Is.EqualTo(new[] { "state-2.ply", "state-9.ply", "state-10.ply", "state-100.ply" }));
            Assert.That(sequence.Frames.Select(f => f.Time), Is.EqualTo(new[] { 0.0, 1 / 20.0, 2 / 20.0, 3 / 20.0 }));
            Assert.That(sequence.Spacing, Is.Zero);
        }

        [TestCase("a2", "a10", -1)]
        [TestCase("a010", "a9", 1)]
        [TestCase("a01", "a1", -1)]
        [TestCase("a", "a1", -1)]
        [TestCase("b1", "a2", 1)]
        [TestCase("f1-2", "f1-11", -1)]
        [TestCase("x99999999999999999999", "x100000000000000000000", -1)]
        public void NumbersInNamesCountAsNumbers(string a, string b, int expected)
        {
            Assert.That(Math.Sign(SequenceFolder.Compare(a, b)), Is.EqualTo(expected));
            Assert.That(Math.Sign(SequenceFolder.Compare(b, a)), Is.EqualTo(-expected));
            Assert.That(SequenceFolder.Compare(a, a), Is.Zero);
        }

        [TestCase(FluidSequenceAxes.AsUnity, 1f, 2f, 3f)]
        [TestCase(FluidSequenceAxes.RightHandedYUp, 1f, 2f, -3f)]
        [TestCase(FluidSequenceAxes.RightHandedZUp, 1f, 3f, 2f)]
        public void AxesAndUnitsAreBroughtToSimulationSpace(FluidSequenceAxes axes, float x, float y, float z)
        {
            File.WriteAllBytes(files["a.ply"],
                SequenceFiles.Ply(new[] { new FluidParticle(new Vector3(1f, 2f, 3f), new Vector3(10f, 20f, 30f), 4u) }));
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 1.0);
            StoredParticle read = Read(new SequenceReader(sequence, axes, 0.5f), 0, 1)[0];
            Assert.That(read.Position, Is.EqualTo(0.5f * new Vector3(x, y, z)));
            Assert.That(read.Velocity, Is.EqualTo(5f * new Vector3(x, y, z)));
        }

        [Test]
        public void ParticlesOutOfOrderAreSortedAndThoseWithoutNumbersCounted()
        {
            var mixed = new[] { new FluidParticle(Vector3.one, Vector3.zero, 9u), new FluidParticle(Vector3.zero, Vector3.zero, 2u) };
            File.WriteAllBytes(files["a.ply"], SequenceFiles.Ply(mixed));
            Assert.That(Read(new SequenceReader(SequenceFolder.Open(files.Folder, 1.0)), 0, 2).Select(p => p.Id),
                Is.EqualTo(new[] { 2u, 9u }));
            File.WriteAllBytes(files["b.ply"], SequenceFiles.Ply(mixed, "ascii", new[] { "float x", "float y", "float z" }));
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 1.0);
            Assert.That((sequence.HasIds, sequence.HasVelocities), Is.EqualTo((false, false)));
            Assert.That(Read(new SequenceReader(sequence), 0, 2).Select(p => p.Id), Is.EqualTo(new[] { 0u, 1u }));
        }

        [Test]
        public void AnAlteredFileIsNamedWhicheverBitItIs()
        {
            WriteSequence();
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 0.0);
            var reader = new SequenceReader(sequence);
            string path = sequence.Frames[3].Path;
            byte[] whole = File.ReadAllBytes(path);
            for (int i = 0; i < 8 * whole.Length; i += 7)
            {
                var altered = (byte[])whole.Clone();
                altered[i / 8] ^= (byte)(1 << i % 8);
                File.WriteAllBytes(path, altered);
                Assert.That(() => Read(reader, 3, 257), Throws.TypeOf<SequenceException>().With.Message.Contains("altered"), $"bit {i}");
            }
            File.WriteAllBytes(path, whole);
            CheckFrame(sequence, 3, p => p);
        }

        [Test]
        public void AFileThatIsCutGrownMissingOrOfOtherNumbersIsNamed()
        {
            WriteSequence();
            ParticleSequence sequence = SequenceFolder.Open(files.Folder, 0.0);
            var reader = new SequenceReader(sequence);
            byte[] whole = File.ReadAllBytes(sequence.Frames[2].Path);
            File.WriteAllBytes(sequence.Frames[2].Path, whole.Take(whole.Length - 1).ToArray());
            Assert.That(() => Read(reader, 2, 257),
                Throws.TypeOf<SequenceException>().With.Message.Contains($"was cut: it has {whole.Length - 1} of {whole.Length} bytes"));
            File.WriteAllBytes(sequence.Frames[2].Path, whole.Append((byte)0).ToArray());
            Assert.That(() => Read(reader, 2, 257), Throws.TypeOf<SequenceException>().With.Message.Contains("more than"));
            File.Delete(sequence.Frames[2].Path);
            Assert.That(() => Read(reader, 2, 257), Throws.InstanceOf<IOException>());
            Assert.That(() => Read(reader, 3, 12), Throws.TypeOf<SequenceException>().With.Message.Contains("13 particles, more than"));
        }

        [TestCase("\"format\": \"other\"", "has the format 'other'")]
        [TestCase("\"version\": 2", "has the version 2")]
        [TestCase("\"spacing\": -0.02", "no spacing")]
        [TestCase("\"spacing\": \"wide\"", "")]
        [TestCase("\"domainSize\": [1, 2]", "no domainSize")]
        [TestCase("\"domainSize\": [1, 0, 3]", "no domainSize")]
        [TestCase("\"frames\": []", "names no frames")]
        [TestCase("\"frames\": [{\"file\": \"../a.ply\", \"time\": 0, \"particles\": 1, \"bytes\": 1, \"crc32\": \"00000000\"}]",
            "names '../a.ply'")]
        [TestCase("\"frames\": [{\"file\": \"\", \"time\": 0, \"particles\": 1, \"bytes\": 1, \"crc32\": \"00000000\"}]", "names ''")]
        [TestCase("\"frames\": [{\"file\": \"a.ply\", \"time\": 0, \"particles\": -1, \"bytes\": 1, \"crc32\": \"00000000\"}]",
            "-1 particles")]
        [TestCase("\"frames\": [{\"file\": \"a.ply\", \"time\": 0, \"particles\": 1, \"bytes\": 3000000000, \"crc32\": \"00000000\"}]",
            "2 GiB")]
        [TestCase("\"frames\": [{\"file\": \"a.ply\", \"time\": 0, \"particles\": 1, \"bytes\": 1, \"crc32\": \"0000000\"}]", "crc32")]
        [TestCase("\"frames\": [{\"file\": \"a.ply\", \"time\": 0, \"particles\": 1, \"bytes\": 1, \"crc32\": \"0000000g\"}]", "crc32")]
        [TestCase("\"frames\": [{\"file\": \"a.ply\", \"time\": 1, \"particles\": 1, \"bytes\": 1, \"crc32\": \"00000000\"}, " +
            "{\"file\": \"b.ply\", \"time\": 1, \"particles\": 1, \"bytes\": 1, \"crc32\": \"00000000\"}]", "the time 1 s for frame 1")]
        [TestCase("no json", "no JSON")]
        public void AManifestThatCannotBePlayedIsNamed(string change, string expected)
        {
            string field = change.Split(':')[0];
            var lines = new[]
            {
                "\"format\": \"sphfluid-sequence\"", "\"version\": 1", "\"source\": \"test\"", "\"spacing\": 0.02",
                "\"domainSize\": [1, 2, 3]",
                "\"frames\": [{\"file\": \"a.ply\", \"time\": 0, \"particles\": 1, \"bytes\": 1, \"crc32\": \"00000000\"}]",
            };
            string text = change == "no json" ? "{" : "{" +
                string.Join(", ", lines.Select(l => l.StartsWith(field, StringComparison.Ordinal) ? change : l)) + "}";
            var exception = Assert.Throws<SequenceException>(() => SequenceManifest.Parse(text));
            Assert.That($"{exception.Message} {exception.Cure}", Does.Contain(expected));
            Assert.That(exception.Cure, Is.Not.Empty);
            File.WriteAllText(files[SequenceManifest.FileName], text);
            Assert.That(() => SequenceFolder.Open(files.Folder, 1.0),
                Throws.TypeOf<SequenceException>().With.Message.Contains("has a sequence.json that"));
        }

        [Test]
        public void FoldersWithNothingToPlayAreNamed()
        {
            Assert.That(() => SequenceFolder.Open(files["nowhere"], 1.0),
                Throws.TypeOf<SequenceException>().With.Message.EqualTo("is no folder"));
            Assert.That(() => SequenceFolder.Open(files.Folder, 1.0),
                Throws.TypeOf<SequenceException>().With.Message.Contains("no .ply files"));
            File.WriteAllBytes(files["a.ply"], SequenceFiles.Ply(Frame(1)));
            foreach (double rate in new[] { 0.0, -1.0, double.NaN, double.PositiveInfinity })
            {
                Assert.That(() => SequenceFolder.Open(files.Folder, rate),
                    Throws.TypeOf<SequenceException>().With.Message.Contains("no times"));
            }
        }

        [Test]
        public void TheWriterRefusesWhatCannotBePlayed()
        {
            Assert.That(() => new FluidSequenceWriter("", Domain, 0.02f), Throws.ArgumentException);
            Assert.That(() => new FluidSequenceWriter(files.Folder, new Vector3(1f, -1f, 1f), 0.02f), Throws.ArgumentException);
            Assert.That(() => new FluidSequenceWriter(files.Folder, Domain, float.NaN), Throws.ArgumentException);
            using (var writer = new FluidSequenceWriter(files.Folder, Domain, 0.02f))
            {
                writer.Write(0.5, Frame(1));
                Assert.That(() => writer.Write(0.5, Frame(1)), Throws.InvalidOperationException);
                Assert.That(() => writer.Write(double.NaN, Frame(1)), Throws.ArgumentException.With.Message.Contains("time"));
                Assert.That(() =>
                    writer.Write(1.0,
                        new[] { new FluidParticle(Vector3.zero, Vector3.zero, 1u), new FluidParticle(Vector3.one, Vector3.zero, 1u) }),
                    Throws.ArgumentException.With.Message.Contains("the id 1"));
                Assert.That(() => writer.Write(1.0, null), Throws.ArgumentNullException);
                Assert.That(writer.FrameCount, Is.EqualTo(1));
            }
            Assert.That(() => new FluidSequenceWriter(files.Folder, Domain, 0.02f),
                Throws.InstanceOf<IOException>().With.Message.Contains("already"));
            Assert.That(SequenceFolder.Open(files.Folder, 0.0).Frames.Count, Is.EqualTo(1));
        }

        [Test]
        public void WhatCannotBeWrittenToItsEndIsNoFrameAndTheManifestStaysWhole()
        {
            using (var writer = new FluidSequenceWriter(files.Folder, Domain, 0.02f))
            {
                // A folder in place of the file that is being written is refused as a full disk is.
                Directory.CreateDirectory(files["frame-00000.ply.part"]);
                Assert.That(() => writer.Write(0.0, Frame(1)), Throws.Exception);
                Assert.That(() => SequenceFolder.Open(files.Folder, 1.0), Throws.TypeOf<SequenceException>(),
                    "nothing passes for a sequence");
                Directory.Delete(files["frame-00000.ply.part"]);
                writer.Write(0.5, Frame(2));
                Directory.CreateDirectory(files["frame-00001.ply.part"]);
                Assert.That(() => writer.Write(1.0, Frame(3)), Throws.Exception);
            }
            Assert.That(SequenceFolder.Open(files.Folder, 1.0).Frames.Count, Is.EqualTo(1));
            Assert.That(Directory.GetFiles(files.Folder).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "frame-00000.ply", "sequence.json" }));
        }

        [Test]
        public void ParticlesThatAreRemovedAreNotWritten()
        {
            using (var writer = new FluidSequenceWriter(files.Folder, Domain, 0.02f))
                writer.Write(0.0,
                    new[] { new FluidParticle(Vector3.one, Vector3.zero, 4u), new FluidParticle { Removed = 1f },
                        new FluidParticle(Vector3.zero, Vector3.one, 2u) });
            Assert.That(Read(new SequenceReader(SequenceFolder.Open(files.Folder, 0.0)), 0, 2).Select(p => p.Id),
                Is.EqualTo(new[] { 2u, 4u }));
        }

        [Test]
        public void ReadingAFileMakesNoGarbageForItsParticles()
        {
            long Made(int count)
            {
                using (var sequence = new SequenceFiles())
                using (var slot = new SequenceSlot(count))
                {
                    sequence.Write(new[] { 0.0 }, _ => ParticleSets.Random(count, Domain, 1f, 2), Domain, 0.02f);
                    var reader = new SequenceReader(SequenceFolder.Open(sequence.Folder, 0.0));
                    long least = long.MaxValue;
                    for (int turn = 0; turn < 5; turn++)
                    {
                        long before = GC.GetAllocatedBytesForCurrentThread();
                        reader.Read(0, slot);
                        least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
                    }
                    return least;
                }
            }
            long small = Made(1);
            TestContext.WriteLine($"{small} bytes to open a file");
            Assert.That(Made(20011), Is.EqualTo(small));
        }

        private void WriteSequence() => files.Write(Times, i => Frame(i), Domain, 0.02f);

        private static FluidParticle[] Frame(int number) => ParticleSets.Random(Counts[number], Domain, 2f, 20 + number);

        private static StoredParticle[] Read(ISequenceReader reader, int frame, int capacity)
        {
            using (var slot = new SequenceSlot(capacity))
            {
                reader.Read(frame, slot);
                return slot.Particles.GetSubArray(0, slot.Count).ToArray();
            }
        }

        private static void CheckFrame(ParticleSequence sequence, int frame, Func<Vector3, Vector3> place)
        {
            FluidParticle[] written = Frame(frame);
            StoredParticle[] read = Read(new SequenceReader(sequence), frame, 257);
            Assert.That(read.Length, Is.EqualTo(written.Length));
            for (int i = 0; i < read.Length; i++)
            {
                Assert.That(read[i].Position.Equals(place(written[i].Position)) && read[i].Velocity.Equals(written[i].VelT0) &&
                    read[i].Id == written[i].Id, $"{i} of frame {frame}");
            }
        }
    }
}
