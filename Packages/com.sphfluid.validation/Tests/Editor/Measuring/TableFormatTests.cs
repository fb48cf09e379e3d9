using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Columns that are stated once are written and read by the same statement.</summary>
    public sealed class TableFormatTests
    {
        private static readonly TableFormat<MadeUpRow> format = MadeUpRow.Format;

        [Test]
        public void ALineHasACellForEachColumn()
        {
            var row =
                new MadeUpRow { Name = "a, \"b\"", Speed = 1234567.0, Steps = 12345678901, IsOn = true, Device = "d", Date = "2026-11-22" };

            Assert.That(format.FirstLine, Is.EqualTo("name,speed_m_s,steps,on,device,date"));
            Assert.That(format.Line(row), Is.EqualTo("\"a, \"\"b\"\"\",1.23457E+06,12345678901,yes,d,2026-11-22"));
            Assert.That(format.Lines(new[] { row }).ToArray(), Is.EqualTo(new[] { format.FirstLine, format.Line(row) }));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void WhatIsNotAFiniteNumberIsAnEmptyCell(double speed)
        {
            string line = format.Line(new MadeUpRow { Speed = speed });

            Assert.That(line, Is.EqualTo(",,0,no,,"));
            Assert.That(Read(line).Speed, Is.NaN);
        }

        [Test]
        public void ALineIsReadAsItWasWritten()
        {
            string line = format
                .Line(new MadeUpRow { Name = "a, \"b\"", Speed = -0.125, Steps = -3, IsOn = true, Device = "d", Date = "2026-11-22" });

            Assert.That(format.Line(Read(line)), Is.EqualTo(line));
        }

        [TestCase("a,1,2,yes,d", "5 cells instead of 6")]
        [TestCase("a,1,2,yes,d,e,f", "7 cells instead of 6")]
        [TestCase("a,fast,2,yes,d,e", "")]
        [TestCase("a,1,2.5,yes,d,e", "")]
        public void ALineWithoutTheColumnsIsRefused(string line, string message) =>
            Assert.That(() => Read(line), Throws.TypeOf<FormatException>().With.Message.Contains(message));

        [Test]
        public void ANumberThatIsTooLargeIsRefused() =>
            Assert.That(() => Read("a,1,99999999999999999999,yes,d,e"), Throws.TypeOf<OverflowException>());

        [Test]
        public void AFileFromBeforeLaterColumnsIsReadAndOneWithOthersIsNot()
        {
            TableFormat<MadeUpRow> grown = new TableFormat<MadeUpRow>("grown.csv").Text("name", r => r.Name, (r, v) => r.Name = v)
                .Later().Number("speed_m_s", r => r.Speed, (r, v) => r.Speed = v).Count("steps", r => r.Steps, (r, v) => r.Steps = v);
            string file = System.IO.Path.GetTempFileName();
            try
            {
                System.IO.File.WriteAllLines(file, new[] { "name", "a", "b" });
                Assert.That(grown.ReadAll(file, () => new MadeUpRow { Speed = 7.0 }).Select(r => (r.Name, r.Speed)),
                    Is.EqualTo(new[] { ("a", 7.0), ("b", 7.0) }));
                System.IO.File.WriteAllLines(file, new[] { "name,speed_m_s", "a,2" });
                Assert.That(grown.ReadAll(file, () => new MadeUpRow()).Single().Speed, Is.EqualTo(2.0));
                System.IO.File.WriteAllLines(file, new[] { "name,speed_m_s", "a,2", "b" });
                Assert.That(() => grown.ReadAll(file, () => new MadeUpRow()),
                    Throws.TypeOf<FormatException>().With.Message.Contains("line 3"));
                System.IO.File.WriteAllLines(file, new[] { "name,colour", "a,2" });
                Assert.That(() => grown.ReadAll(file, () => new MadeUpRow()),
                    Throws.TypeOf<FormatException>().With.Message.Contains("columns"));
            }
            finally
            {
                System.IO.File.Delete(file);
            }
            Assert.That(grown.Reads("name"), Is.True);
            Assert.That(grown.Reads("speed_m_s"), Is.False);
        }

        private static MadeUpRow Read(string line)
        {
            var row = new MadeUpRow();
            format.Read(line, row);
            return row;
        }
    }
}
