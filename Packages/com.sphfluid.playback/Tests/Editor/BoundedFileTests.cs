using System;
using System.IO;
using System.Threading.Tasks;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What is no regular file, or too long, is refused where a sequence reads: none of it is waited for or read to an end that it does not
    /// have.
    /// </summary>
    public sealed class BoundedFileTests
    {
        private const int MostSeconds = 60; // a test that hangs fails

        private static readonly string[] NoFiles =
        {
            ": > $0", "mkfifo $0", "mkfifo $0.pipe && ln -s $0.pipe $0", "ln -s /dev/zero $0", "ln -s /dev/tty $0", "mkdir $0",
            "ln -s $0 $0", "ln -s /nowhere/at/all $0", "ln -s . $0",
        };

        private SequenceFiles files;

        [SetUp]
        public void SetUp() => files = new SequenceFiles();

        [TearDown]
        public void TearDown() => files.Dispose();

        private string Make(string command, string name)
        {
            Programs.Run("sh", "-c", command, files[name]);
            return files[name];
        }

        private static void Refused(Action read)
        {
            Task<bool> task = Task.Run(() =>
            {
                try
                {
                    read();
                    return false;
                }
                catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException ||
                    exception is SequenceException)
                {
                    return true;
                }
            });
            Assert.That(task.Wait(MostSeconds * 1000), Is.True, "it waits");
            Assert.That(task.Result, Is.True, "it is read");
        }

        private void WriteSequence() =>
            files.Write(new[] { 0.0, 1.0 }, i => ParticleSets.Random(3, Vector3.one, 1f, i), Vector3.one, 0.02f);

        private void ReadFrame(int frame, double rate)
        {
            using (var slot = new SequenceSlot(3)) new SequenceReader(SequenceFolder.Open(files.Folder, rate)).Read(frame, slot);
        }

        [TestCaseSource(nameof(NoFiles))]
        public void WhatIsNoFileIsNotRead(string command)
        {
            string path = Make(command, "thing");
            Refused(() => BoundedFile.Open(path).Dispose());
            Refused(() => BoundedFile.ReadText(path, 10));
        }

        [TestCaseSource(nameof(NoFiles))]
        public void ASequenceWithoutAManifestToReadIsRefused(string command)
        {
            Make(command, SequenceManifest.FileName);
            Refused(() => SequenceFolder.Open(files.Folder, 1.0));
        }

        [TestCaseSource(nameof(NoFiles))]
        public void AFrameThatIsNoFileIsRefused(string command)
        {
            Make(command, "1.ply");
            Refused(() => ReadFrame(0, 1.0));
            File.WriteAllBytes(files["0.ply"], SequenceFiles.Ply(ParticleSets.Random(3, Vector3.one, 1f, 2)));
            ReadFrame(0, 1.0); // the other is read
        }

        [TestCaseSource(nameof(NoFiles))]
        public void AListedFrameThatIsNoFileIsRefused(string command)
        {
            WriteSequence();
            string path = SequenceFolder.Open(files.Folder, 0.0).Frames[1].Path;
            File.Delete(path);
            Make(command, Path.GetFileName(path));
            ReadFrame(0, 0.0);
            Refused(() => ReadFrame(1, 0.0));
        }

        [Test]
        public void LinksToFilesAreFollowed()
        {
            WriteSequence();
            foreach (string file in Directory.GetFiles(files.Folder)) Make("mv $0 $0.real && ln -s $0.real $0", Path.GetFileName(file));
            ReadFrame(1, 0.0);
            Make("chmod a-w $0.real", SequenceManifest.FileName);
            ReadFrame(1, 0.0);
        }

        [Test]
        public void ALongManifestIsRefusedUnread()
        {
            using (FileStream sparse = File.Create(files[SequenceManifest.FileName])) sparse.SetLength(1L << 40);
            var exception = Assert.Throws<SequenceException>(() => SequenceFolder.Open(files.Folder, 1.0));
            Assert.That(exception.Message, Is.EqualTo("has a sequence.json of more than 64 MiB"));
            Assert.That(exception.Cure, Does.Contain("Divide"));
            Assert.That(BoundedFile.ReadText(files[SequenceManifest.FileName], int.MaxValue), Is.Null);
        }
    }
}
