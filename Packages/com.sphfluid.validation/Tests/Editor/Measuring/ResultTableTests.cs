using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Rows on disk: what is added, what is replaced, and what a later session continues.</summary>
    public sealed class ResultTableTests : FolderTests
    {
        private string File => Path.Combine(folder, "made-up.csv");

        [Test]
        public void EveryRowIsOnDiskWithDeviceAndDay()
        {
            var table = new ResultTable<MadeUpRow>(MadeUpRow.Format, folder, "a device");
            table.Add(new MadeUpRow { Name = "first" });
            Assert.That(Lines().Length, Is.EqualTo(2));
            table.Add(new MadeUpRow { Name = "second", Date = "2026-11-22" });

            Assert.That(Lines()[1], Does.StartWith("first,").And.Match(@",a device,\d{4}-\d\d-\d\d$"));
            Assert.That(Lines()[2], Does.EndWith(",a device,2026-11-22"), "a day that is given stays");
        }

        [Test]
        public void ANewerRunReplacesTheOlder()
        {
            var table = new ResultTable<MadeUpRow>(MadeUpRow.Format, folder, "a device");
            table.Add(new MadeUpRow { Name = "one", Speed = 1.0 }, new MadeUpRow { Name = "one", Speed = 2.0 });
            table.Add(new MadeUpRow { Name = "other", Speed = 3.0 });
            table.Add(new MadeUpRow { Name = "one", Speed = 4.0 });

            Assert.That(table.Rows.Select(r => r.Speed), Is.EqualTo(new[] { 3.0, 4.0 }));
            Assert.That(Lines().Length, Is.EqualTo(3));
        }

        [Test]
        public void RowsWithoutAKeyAllStay()
        {
            var table = new ResultTable<MadeUpRow>(MadeUpRow.Format, folder, "a device");
            table.Add(new MadeUpRow());
            table.Add(new MadeUpRow());

            Assert.That(Lines().Length, Is.EqualTo(3));
        }

        [Test]
        public void WhatIsNotMeasuredYetIsNotWritten()
        {
            var table = new ResultTable<MadeUpRow>(MadeUpRow.Format, folder, "a device");
            var row = new MadeUpRow { IsEmpty = true };
            table.Add(row);
            Assert.That(Lines(), Is.EqualTo(new[] { MadeUpRow.Format.FirstLine }));
            row.IsEmpty = false;
            table.Write();

            Assert.That(Lines().Length, Is.EqualTo(2));
        }

        [Test]
        public void ALaterSessionContinues()
        {
            new ResultTable<MadeUpRow>(MadeUpRow.Format, folder, "a device").Add(new MadeUpRow { Name = "one", Date = "2026-11-20" });
            ResultTable<MadeUpRow> table = Resume("a device");
            table.Add(new MadeUpRow { Name = "two" });

            Assert.That((table.Contains("one"), table.Contains("two"), table.Contains("three")), Is.EqualTo((true, true, false)));
            Assert.That(Lines()[1], Does.EndWith("2026-11-20"));
            Assert.That(Lines().Length, Is.EqualTo(3));
        }

        [Test]
        public void WithoutAFileItBeginsEmpty() => Assert.That(Resume("a device").Rows, Is.Empty);

        [TestCase("name,speed\n", "columns of this version")]
        [TestCase("", "columns of this version")]
        [TestCase("name,speed_m_s,steps,on,device,date\none,1,2,yes,a device,2026-11-22\none,1\n", "broken line 3")]
        [TestCase("name,speed_m_s,steps,on,device,date\none,1,2,yes,another,2026-11-22\n", "has runs of 'another', and this is 'a device'")]
        public void AFileThatCannotBeContinuedIsNamed(string text, string message)
        {
            Directory.CreateDirectory(folder);
            System.IO.File.WriteAllText(File, text);

            Assert.That(() => Resume("a device"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains(message).And.Message.Contains("made-up.csv"));
            Assert.That(System.IO.File.ReadAllText(File), Is.EqualTo(text));
        }

        private ResultTable<MadeUpRow> Resume(string device) =>
            ResultTable<MadeUpRow>.Resume(MadeUpRow.Format, folder, device, () => new MadeUpRow());

        private string[] Lines() => System.IO.File.ReadAllLines(File);
    }
}
