using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class ChartTableTests : FolderTests
    {
        private const string Device = "A \"fast\" one, with 2 cores";

        private static readonly FlatCase flat = new FlatCase("flat");

        [Test]
        public void HasTheColumnsThatOthersRead()
        {
            Assert.That(ChartRow.Format.FirstLine, Is.EqualTo("case,method,dx,kappa,dt_fraction,c_or_iterations,particles,seed," +
                "gpu_ms_per_sim_s,cpu_ms_per_sim_s,error,error_name,failed,reason,device,date,steps,dt_s,gpu_ms_low,gpu_ms_high," +
                "time_spread"));
        }

        [Test]
        public void EveryErrorOfARunHasALineTheMainOneFirst()
        {
            ResultTable<ChartRow> table = Written(FlatCase.Result(1234.5, 0.125));
            string[] lines = File.ReadAllLines(Path.Combine(folder, "accuracy.csv"));

            Assert.That(table.Rows, Has.Count.EqualTo(2));
            Assert.That(lines, Has.Length.EqualTo(3));
            Assert.That(lines[1],
                Is.EqualTo(
                    "flat,thesis,0.0833333,2,0.5,5,1728,3,1234.5,617.25,0.125,height,0,,\"A \"\"fast\"\" one, with 2 " +
                    "cores\",2026-11-21,120,,,,"));
            Assert.That(lines[2], Does.Contain(",-0.0125,drift,0,"));
        }

        [Test]
        public void AFailedRunHasALineWithItsReason()
        {
            Written(FlatCase.Result(double.NaN, 0.0, "3 of 1728 values are not finite, at 0.2 s"));

            Assert.That(File.ReadAllLines(Path.Combine(folder, "accuracy.csv")).Last(),
                Is.EqualTo(
                    "flat,thesis,0.0833333,2,0.5,5,1728,3,,,,height,1,\"3 of 1728 values are not finite, at 0.2 s\",\"A \"\"fast\"\" " +
                    "one, with 2 cores\",2026-11-21,120,,,,"));
        }

        [Test]
        public void AnErrorThatCouldNotBeMeasuredIsAFailure()
        {
            ChartRow row = Written(FlatCase.Result(10.0, double.NaN)).Rows[0];

            Assert.That(row.Failed, Is.True);
            Assert.That(row.Reason, Does.Contain("height could not be measured"));
        }

        [Test]
        public void ASecondErrorThatCouldNotBeMeasuredIsSaidInItsRow()
        {
            CaseResult result = FlatCase.Result(10.0, 0.1);
            result.Errors = new[] { result.Errors[0], new CaseError("drift", double.NaN) };
            IReadOnlyList<ChartRow> rows = Written(result).Rows;

            Assert.That(rows.Select(r => (r.Failed, r.Reason)), Is.EqualTo(new[] { (false, ""), (false, "drift could not be measured") }));
        }

        [Test]
        public void ReadsWhatItWrote()
        {
            ResultTable<ChartRow> written = Written(FlatCase.Result(1234.5, 0.125));
            ResultTable<ChartRow> read = Resume(Device);

            Assert.That(read.Rows.Select(ChartRow.Format.Line), Is.EqualTo(written.Rows.Select(ChartRow.Format.Line)));
            Assert.That(read.Contains(Run(3).Key), Is.True);
            Assert.That(read.Contains(Run(4).Key), Is.False, "another seed");
            CaseParameters other = flat.Base(CaseMethod.Find("thesis"));
            other.SupportRatio = 2.25;
            Assert.That(read.Contains(new ChartRun(new ChartConfig(flat, other, ChartFactor.Support), 3).Key), Is.False, "another κ");
        }

        [Test]
        public void ANewerRunReplacesAllLinesOfTheOlder()
        {
            Written(FlatCase.Result(1234.5, 0.125));
            ResultTable<ChartRow> table = Resume(Device);
            table.Add(ChartRow.Of(Run(3), FlatCase.Result(1.0, 0.1)));

            Assert.That(table.Rows.Select(r => r.GpuMsPerSecond), Is.EqualTo(new[] { 1.0, 1.0 }));
        }

        [Test]
        public void RefusesAnotherDevicesTable()
        {
            Written(FlatCase.Result(1.0, 0.1));

            var exception = Assert.Throws<CommandLineException>(() => Resume("another"));
            Assert.That(exception.Message, Does.Contain("another").And.Contain(Device).And.Contain("--out"));
        }

        [Test]
        public void RefusesOtherColumnsAndBrokenLines()
        {
            Written(FlatCase.Result(1.0, 0.1));
            string file = Path.Combine(folder, "accuracy.csv");
            string text = File.ReadAllText(file);
            File.WriteAllText(file, text + "flat,thesis,0.1\n");
            Assert.That(() => Resume(Device), Throws.TypeOf<CommandLineException>().With.Message.Contains("line 4"));

            File.WriteAllText(file, text.Replace("kappa", "k"));
            Assert.That(() => Resume(Device), Throws.TypeOf<CommandLineException>().With.Message.Contains("columns"));
        }

        [TestCase("a,b", new[] { "a", "b" })]
        [TestCase("a,\"b, \"\"c\"\"\",", new[] { "a", "b, \"c\"", "" })]
        [TestCase("", new[] { "" })]
        public void CellsAreSplitAsTheyWereJoined(string line, string[] cells)
        {
            Assert.That(CsvText.Split(line), Is.EqualTo(cells));
            Assert.That(CsvText.Join(cells), Is.EqualTo(line));
        }

        private ResultTable<ChartRow> Resume(string device) =>
            ResultTable<ChartRow>.Resume(ChartRow.Format, folder, device, () => new ChartRow());

        private ResultTable<ChartRow> Written(CaseResult result)
        {
            var table = new ResultTable<ChartRow>(ChartRow.Format, folder, Device);
            ChartRow[] rows = ChartRow.Of(Run(3), result);
            foreach (ChartRow row in rows) row.Date = "2026-11-21";
            table.Add(rows);
            return table;
        }

        private static ChartRun Run(int seed) =>
            new ChartRun(new ChartConfig(flat, flat.Base(CaseMethod.Find("thesis")), ChartFactor.Base), seed);
    }
}
