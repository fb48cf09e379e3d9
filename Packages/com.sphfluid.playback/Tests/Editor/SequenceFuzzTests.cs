using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Sequences broken at random: each file is played or refused in one message, and nothing else happens. SPHFLUID_FUZZ=5000 breaks so
    /// many; SPHFLUID_FUZZ_SEED=7 starts elsewhere.
    /// </summary>
    public sealed class SequenceFuzzTests
    {
        private const int UsualCount = 600;
        private const int Most = 64;

        private static readonly string[] Words =
        {
            "0", "-1", "1e400", "NaN", "Infinity", "4294967296", "2147483647", "2147483648", "99999999999999999999", "null", "true", "[]",
            "{}", "\"\"", "double", "list", "uchar", "vertex",
            "id", "ascii", "binary_big_endian", "binary_little_endian", "end_header", "ply", "..", "\u0661", "1.5", "0x10",
        };

        [Test]
        public void BrokenFilesArePlayedOrRefusedInOneMessage()
        {
            int count = Setting("SPHFLUID_FUZZ", UsualCount), seed = Setting("SPHFLUID_FUZZ_SEED", 20261126), refused = 0;
            using (var sequence = new SequenceFiles())
            using (var folder = new SequenceFiles())
            using (var slot = new SequenceSlot(Most))
            {
                sequence.Write(new[] { 0.0, 0.5, 1.0 }, i => ParticleSets.Random(Most - i, Vector3.one, 1f, i), Vector3.one, 0.1f);
                File.WriteAllBytes(folder["a.ply"],
                    SequenceFiles.Ply(ParticleSets.Random(Most, Vector3.one, 1f, 5), "ascii",
                        new[] { "float x", "double y", "float z", "uint id" }));
                File.WriteAllBytes(folder["b.ply"],
                    SequenceFiles.Ply(ParticleSets.Random(31, Vector3.one, 1f, 6), "binary_big_endian",
                        new[] { "float x", "short a", "float y", "double z", "uint id" },
                    "element face 1\nproperty list uchar int corners\n", new byte[] { 1, 0, 0, 0, 9 }));
                for (int i = 0; i < count; i++)
                {
                    var random = new System.Random(unchecked(seed * 31 + i));
                    string[] files = Directory.GetFiles((i % 2 == 0 ? sequence : folder).Folder)
                        .OrderBy(f => f, StringComparer.Ordinal).ToArray();
                    string file = files[random.Next(files.Length)];
                    byte[] original = File.ReadAllBytes(file);
                    File.WriteAllBytes(file, Broken(original, random));
                    try
                    {
                        Play(Path.GetDirectoryName(file), slot);
                    }
                    catch (SequenceException exception)
                    {
                        refused++;
                        Assert.That(exception.Message, Does.Not.Contain("\n"), $"number {i}");
                        Assert.That(exception.Message.Length, Is.InRange(1, 1000), $"number {i}");
                    }
                    catch (Exception exception)
                    {
                        Assert.Fail($"number {i}, {Path.GetFileName(file)}: {exception}");
                    }
                    finally
                    {
                        File.WriteAllBytes(file, original);
                    }
                }
                Play(sequence.Folder, slot);
                Play(folder.Folder, slot);
            }
            Assert.That(refused, Is.InRange(count / 3, count), "broken at all, and not only");
        }

        private static void Play(string folder, SequenceSlot slot)
        {
            ParticleSequence sequence = SequenceFolder.Open(folder, 30.0);
            if (sequence.MostBytes > 1 << 26) return; // more than any budget of a test
            var reader = new SequenceReader(sequence);
            for (int frame = 0; frame < sequence.Frames.Count; frame++)
            {
                try
                {
                    reader.Read(frame, slot);
                    Assert.That(slot.Count, Is.LessThanOrEqualTo(Most));
                }
                catch (FileNotFoundException)
                {
                    throw new SequenceException("is not there");
                }
            }
        }

        private static byte[] Broken(byte[] original, System.Random random)
        {
            byte[] bytes = original;
            for (int left = 1 + random.Next(3); left > 0; left--) bytes = BrokenOnce(bytes, random);
            return bytes;
        }

        private static byte[] BrokenOnce(byte[] bytes, System.Random random)
        {
            int at = random.Next(bytes.Length + 1);
            switch (random.Next(6))
            {
                case 0:
                    return bytes.Take(at).ToArray();
                case 1:
                    var noise = new byte[1 + random.Next(64)];
                    random.NextBytes(noise);
                    return bytes.Take(at).Concat(noise).Concat(bytes.Skip(at)).ToArray();
                case 2:
                    return bytes.Take(at).Concat(bytes.Skip(Math.Min(bytes.Length, at + 1 + random.Next(40)))).ToArray();
                case 3:
                    var flipped = (byte[])bytes.Clone();
                    for (int i = 1 + random.Next(8); i > 0 && flipped.Length > 0; i--)
                    {
                        flipped[random.Next(flipped.Length)] ^= (byte)(1 << random.Next(8));
                    }
                    return flipped;
                default: // another word in a line
                    string[] lines = Encoding.GetEncoding("ISO-8859-1").GetString(bytes).Split('\n');
                    int line = random.Next(Math.Min(lines.Length, 16));
                    string[] words = lines[line].Split(' ');
                    words[random.Next(words.Length)] = Words[random.Next(Words.Length)];
                    lines[line] = string.Join(" ", words);
                    return Encoding.GetEncoding("ISO-8859-1").GetBytes(string.Join("\n", lines));
            }
        }

        private static int Setting(string name, int usual) =>
            int.TryParse(Environment.GetEnvironmentVariable(name), NumberStyles.Integer, CultureInfo.InvariantCulture, out int value)
                ? value : usual;
    }
}
