using System;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What an export may write to, and the hashes of what it wrote.</summary>
    public sealed class ExportFolderTests
    {
        private string path;

        [SetUp]
        public void SetUp() => path = TestFolder.Fresh();

        [TearDown]
        public void TearDown() => TestFolder.Delete(path);

        private string[] Names() => Directory.GetFiles(path).Select(Path.GetFileName).OrderBy(n => n, StringComparer.Ordinal).ToArray();

        private void Export(params string[] names)
        {
            ExportFolder folder = ExportFolder.Open(path);
            foreach (string name in names) folder.WriteText(name, "abc");
            folder.Close(new ExportManifest());
        }

        [Test]
        public void TheManifestHasSizeAndHashOfEveryFile()
        {
            Export("a.txt", "b.txt");

            ExportManifest manifest = JsonUtility.FromJson<ExportManifest>(File.ReadAllText(Path.Combine(path, "manifest.json")));
            Assert.That(manifest.format, Is.EqualTo("sphfluid-export"));
            Assert.That(manifest.files.Select(f => f.name), Is.EqualTo(new[] { "a.txt", "b.txt" }));
            foreach (ExportManifest.Entry file in manifest.files)
            {
                Assert.That(file.bytes, Is.EqualTo(3));
                Assert.That(file.sha256, Is.EqualTo("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"), "FIPS 180-2, B.1");
            }
        }

        [Test]
        public void AnEarlierExportIsReplaced()
        {
            Export("a.txt", "body-000.npy");
            File.WriteAllText(Path.Combine(path, "mine.txt"), "");
            Export("a.txt");

            Assert.That(Names(), Is.EqualTo(new[] { "a.txt", "manifest.json", "mine.txt" }));
        }

        [Test]
        public void AFolderOfOtherThingsIsRefused()
        {
            Directory.CreateDirectory(path);
            File.WriteAllText(Path.Combine(path, "mine.txt"), "");

            Assert.That(() => ExportFolder.Open(path), Throws.TypeOf<IOException>().With.Message.Contains("no export wrote"));
            Assert.That(Names(), Is.EqualTo(new[] { "mine.txt" }));
        }

        [TestCase("{}")]
        [TestCase("[1, 2")]
        [TestCase("")]
        public void AManifestOfSomethingElseIsRefused(string text)
        {
            Directory.CreateDirectory(path);
            File.WriteAllText(Path.Combine(path, "manifest.json"), text);

            Assert.That(() => ExportFolder.Open(path), Throws.TypeOf<IOException>().With.Message.Contains("no export wrote"));
        }

        [TestCase(": > $0")]
        [TestCase("mkfifo $0")]
        [TestCase("mkfifo $0.pipe && ln -s $0.pipe $0")]
        [TestCase("ln -s /dev/zero $0")]
        [TestCase("ln -s /dev/tty $0")]
        [TestCase("mkdir $0")]
        [TestCase("ln -s $0 $0")]
        [TestCase("ln -s . $0")]
        public void AManifestThatIsNoFileIsNotWaitedFor(string command)
        {
            Directory.CreateDirectory(path);
            Programs.Run("sh", "-c", command, Path.Combine(path, ExportFolder.ManifestName));
            Task<bool> refused = Task.Run(() =>
            {
                try
                {
                    ExportFolder.Open(path);
                    return false;
                }
                catch (IOException)
                {
                    return true;
                }
            });
            Assert.That(refused.Wait(60_000) && refused.Result, Is.True);
        }

        [Test]
        public void AManifestRemovesNothingOutsideItsFolder()
        {
            string outside = path + ".txt";
            File.WriteAllText(outside, "");
            try
            {
                Directory.CreateDirectory(path);
                var forged = new ExportManifest { format = ExportManifest.FormatName };
                forged.files.Add(new ExportManifest.Entry { name = "../" + Path.GetFileName(outside) });
                File.WriteAllText(Path.Combine(path, "manifest.json"), JsonUtility.ToJson(forged));
                ExportFolder.Open(path);

                Assert.That(File.Exists(outside), Is.True);
            }
            finally
            {
                File.Delete(outside);
            }
        }

        [Test]
        public void AFileIsNoFolder()
        {
            File.WriteAllText(path, "");
            try
            {
                Assert.That(() => ExportFolder.Open(path), Throws.TypeOf<IOException>().With.Message.Contains("is a file"));
            }
            finally
            {
                File.Delete(path);
            }
        }
    }
}
