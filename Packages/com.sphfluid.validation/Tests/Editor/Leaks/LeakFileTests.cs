using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the leak scenes read and write.</summary>
    public sealed class LeakFileTests
    {
        private string folder;

        [SetUp]
        public void MakeFolder()
        {
            folder = TestFolder.Fresh();
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void RemoveFolder() => TestFolder.Delete(folder);

        [Test]
        public void ReadsFacesOfAnObjFile()
        {
            Vector3[] corners =
                ObjFile.Read(
                    Written(
                        "# a square, then a triangle\nv 0 0 0\nv 1 0 0\nv 1 1e0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -4 -3/2 " +
                        "-2/2/1\n"));

            Vector3 a = Vector3.zero, b = Vector3.right, c = new Vector3(1f, 1f, 0f), d = Vector3.up;
            Assert.That(corners, Is.EqualTo(new[] { a, b, c, a, c, d, a, b, c }));
        }

        [TestCase("v 1 2\n", "line 1")]
        [TestCase("v 1 2 3\nf 1 2 3\n", "line 2")]
        [TestCase("v 1 x 3\n", "v 1 x 3")]
        public void NamesTheBrokenLine(string text, string named)
        {
            var exception = Assert.Throws<InvalidDataException>(() => ObjFile.Read(Written(text)));

            Assert.That(exception.Message, Does.Contain(named));
        }

        [Test]
        public void WritesALineForEachRun()
        {
            LeakScene scene = LeakSceneEntry.Find("two-sided").Build(2.0);
            var table = new ResultTable<LeakResult>(LeakResult.Format, folder, "a device, with a comma");
            table.Add(new LeakResult { Scene = scene, Escapes = 3, End = scene.Particles });
            table.Add(new LeakResult { Scene = scene, End = scene.Particles });

            string[] lines = File.ReadAllLines(Path.Combine(folder, "leaks.csv"));
            string[] columns = CsvText.Split(lines[0]), cells = CsvText.Split(lines[1]);

            Assert.That(lines.Length, Is.EqualTo(3));
            Assert.That(cells.Length, Is.EqualTo(columns.Length));
            Assert.That(cells[System.Array.IndexOf(columns, "escapes")], Is.EqualTo("3"));
            Assert.That(cells[System.Array.IndexOf(columns, "failure")], Is.EqualTo("escapes"));
            Assert.That(cells[System.Array.IndexOf(columns, "drag")], Is.EqualTo("0"));
            Assert.That(cells[System.Array.IndexOf(columns, "held_share")], Is.Empty, "it was not measured");
        }

        [Test]
        public void TakesScenesAndFolder()
        {
            LeakArguments all = LeakArguments.Parse(new[] { "player", "--" }),
                some = LeakArguments.Parse(new[] { "player", "--", "--scene", "knife", "cup", "--out=there" });

            Assert.That(all.Scenes, Is.EqualTo(LeakSceneEntry.All));
            Assert.That(some.Scenes.Select(s => s.Name), Is.EqualTo(new[] { "knife", "cup" }));
            Assert.That(some.OutputFolder, Is.EqualTo("there"));
        }

        [TestCase("--scene", "sieve", "funnel")]
        [TestCase("--sceen", "cup", "--scene")]
        public void NamesTheFlagAndTheCure(string flag, string value, string mentioned)
        {
            var exception = Assert.Throws<CommandLineException>(() => LeakArguments.Parse(new[] { "player", "--", flag, value }));

            Assert.That(exception.Message, Does.Contain(flag).And.Contain(mentioned));
        }

        private string Written(string text)
        {
            string file = Path.Combine(folder, "shape.obj");
            File.WriteAllText(file, text);
            return file;
        }
    }
}
