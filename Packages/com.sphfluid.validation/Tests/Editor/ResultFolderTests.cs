using System.IO;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>What measurements may replace in the folder of --out.</summary>
    public sealed class ResultFolderTests : FolderTests
    {
        private static readonly ResultFile table = ResultFile.Table("speed.csv", new[] { "case", "speed_m_s" });
        private static readonly ResultFile script = ResultFile.Text("speed.gp", "# Draws speed.png");
        private static readonly ResultFile drawn = ResultFile.Drawn("speed.png", "speed.gp");
        private static readonly ResultFile curve = ResultFile.Table("curves/a.csv", new[] { "x", "y" });
        private static readonly ResultFile picture = ResultFile.Picture("still.png");

        [Test]
        public void ANewFolderIsMade()
        {
            Open().Close();
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty, "without results no list is needed");
        }

        [TestCase("speed.csv", "name,price\n")]
        [TestCase("speed.csv", "case,speed_m_s,notes\n")]
        [TestCase("speed.csv", "")]
        [TestCase("speed.csv.tmp", "case,speed_m_s\n")]
        [TestCase("speed.gp", "set terminal png\n")]
        [TestCase("speed.png", "a photograph")]
        [TestCase("still.png", "a photograph")]
        [TestCase("curves/a.csv", "t,y\n")]
        public void AFileOfTheUsersIsNamedAndStays(string name, string text)
        {
            Write(name, text);
            Assert.That(Refused(),
                Does.Contain(folder.Substring(0, 10)).And.Contain(name.Replace(".tmp", "")).And.Contain("Name another folder"));
            Assert.That(File.ReadAllText(Path.Combine(folder, name)), Is.EqualTo(text));
            Assert.That(File.Exists(Path.Combine(folder, ResultFolder.ListName)), Is.False);
        }

        [Test]
        public void SeveralAreCounted()
        {
            Write("speed.png", "");
            Write("still.png", "");
            Write("curves/a.csv", "");
            Assert.That(Refused(), Does.Contain("holds curves/a.csv and 2 more"));
        }

        [Test]
        public void OtherFilesBesideResultsDoNotMatter()
        {
            Write("speed.csv", "case,speed_m_s\n");
            Write("notes.txt", "mine");
            Open().Close();
            Assert.That(File.ReadAllText(Path.Combine(folder, "notes.txt")), Is.EqualTo("mine"));
        }

        [TestCase("notes.txt")]
        [TestCase(".hidden")]
        [TestCase("sub/notes.txt")]
        public void AFolderThatNoMeasurementMadeIsRefusedAndStaysAsItIs(string name)
        {
            Write(name, "mine");
            string[] before = Directory.GetFileSystemEntries(folder, "*", SearchOption.AllDirectories);
            Assert.That(Refused(), Does.Contain("is not empty, and no measurement made it. Name a new folder"));
            Assert.That(Directory.GetFileSystemEntries(folder, "*", SearchOption.AllDirectories), Is.EquivalentTo(before));
        }

        [Test]
        public void AFolderInUseIsRefused()
        {
            ResultFolder first = Open();
            Assert.That(Refused(), Does.Contain("another measurement writes to"));
            first.Close();
            Assert.That(() => Open().Close(), Throws.Nothing);
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
        }

        [Test]
        public void WhatWasListedIsReplaced()
        {
            ResultFolder first = Open();
            Write("still.png", "drawn");
            Write("speed.csv", "columns,of,an,earlier,version\n");
            first.Close();
            Assert.That(() => Open().Close(), Throws.Nothing);
        }

        [Test]
        public void WhatAnInterruptedRunLeftIsReplaced()
        {
            Write(ResultFolder.ListName, "still.png\nspeed.csv\n");
            Write(ResultFolder.LockName, "");
            Write("still.png", "half a picture");
            Write("speed.csv.tmp", "case,spe");
            Assert.That(() => Open().Close(), Throws.Nothing);
        }

        [Test]
        public void ANameThatWasNotNeededStaysTheUsers()
        {
            Open().Close();
            Write("still.png", "a photograph");
            Assert.That(Refused(), Does.Contain("still.png"));
        }

        [Test]
        public void TwoMeasurementsShareAFolder()
        {
            ResultFolder first = ResultFolder.Open(folder, new[] { picture });
            Write("still.png", "drawn");
            first.Close();
            ResultFolder.Open(folder, new[] { table }).Close();
            Assert.That(() => ResultFolder.Open(folder, new[] { picture }).Close(), Throws.Nothing);
        }

        [TestCase("\n")]
        [TestCase("\r\n")]
        public void CommittedResultsWithoutAListAreReplaced(string end)
        {
            Write("speed.csv", "case,speed_m_s" + end + "fall,3" + end);
            Write("speed.gp", "# Draws speed.png" + end + "plot 1" + end);
            Write("speed.png", "drawn by the script");
            Write("curves/a.csv", "x,y" + end);
            Assert.That(() => Open().Close(), Throws.Nothing);
        }

        [Test]
        public void APictureBesideAnotherScriptIsTheUsers()
        {
            Write("speed.gp", "plot sin(x)\n");
            Write("speed.png", "a sine");
            Assert.That(Refused(), Does.Contain("speed.gp and 1 more"));
        }

        [TestCase("speed.csv", true)]
        [TestCase("curves", false)]
        public void AFolderInPlaceOfAFileIsNamedAndAFileInPlaceOfAFolder(string name, bool isFolder)
        {
            if (isFolder)
                Directory.CreateDirectory(Path.Combine(folder, name));
            else
                Write(name, "mine");
            Assert.That(Refused(), Does.Contain(name));
        }

        [Test]
        public void AFolderThatCannotBeWrittenIsOneLine()
        {
            Write("speed.csv", "case,speed_m_s\n");
            // The list cannot be written where a folder has its name.
            Directory.CreateDirectory(Path.Combine(folder, ResultFolder.ListName));
            string message = Refused();
            Assert.That(message, Does.StartWith("--out: the folder '").And.Contain("cannot be written"));
            Assert.That(message, Does.Not.Contain("\n"));
        }

        private ResultFolder Open() => ResultFolder.Open(folder, new[] { table, script, drawn, curve, picture });

        private string Refused() => Assert.Throws<CommandLineException>(() => Open()).Message;

        private void Write(string name, string text)
        {
            string path = Path.Combine(folder, name);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, text);
        }
    }
}
