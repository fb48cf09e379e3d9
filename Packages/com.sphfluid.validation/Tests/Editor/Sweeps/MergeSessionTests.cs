using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Shards become the whole, or what keeps them from it is named. The runs are made up.</summary>
    public sealed class MergeSessionTests
    {
        private ShardedCharts charts;
        private string commit;

        [SetUp]
        public void SetUp()
        {
            commit = Environment.GetEnvironmentVariable(SweepBuild.CommitVariable);
            charts = new ShardedCharts();
        }

        [TearDown]
        public void TearDown()
        {
            Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, commit);
            charts.Dispose();
        }

        [Test]
        public void TheWholeIsWhatOneMachineWrites([Values(1, 7)] int shards)
        {
            // A chart that goes on has its rows from the file, with six digits, as merge has them.
            charts.Measure("whole");
            charts.Measure("whole");
            charts.MeasureAll(shards);
            charts.Merge("merged", Enumerable.Range(1, shards).Select(i => i.ToString()).Reverse().ToArray());

            foreach (string file in new[] { "accuracy.csv", "pareto.csv", "equal-cost.csv", "error-fits.csv", "accuracy.gp",
                "case-ellipsoid.gp", "curves/ellipsoid.standard.csv" })
            {
                Assert.That(charts.Lines("merged", file), Is.EqualTo(charts.Lines("whole", file)), file);
            }
            Assert.That(File.Exists(Path.Combine(charts.Folder("merged"), "report.html")), Is.True);
            Assert.That(charts.Lines("merged", "shards.csv"), Has.Length.EqualTo(1 + shards));
        }

        [Test]
        public void MergingAgainReplacesWhatAMergeWrote()
        {
            charts.MeasureAll(2);
            charts.Merge("merged", "1", "2");
            string[] first = charts.Lines("merged", "accuracy.csv");
            charts.Merge("merged", "2", "1");

            Assert.That(charts.Lines("merged", "accuracy.csv"), Is.EqualTo(first));
            Expect("has what these shards do not have: accuracy.csv|ellipsoid|standard|", "merged", "1");
        }

        [Test]
        public void RunsThatNoShardHasAreNamedAndTheRestIsWritten()
        {
            charts.MeasureAll(3);
            int missing = charts.Lines("2", "shard-runs.csv").Length - 1, all = charts.Lines("2", "shard-plan.csv").Length - 1;
            string one = CsvText.Split(charts.Lines("2", "shard-runs.csv")[1])[0];
            var exception = Assert.Throws<IncompleteException>(() => charts.Merge("merged", "1", "3"));

            Assert.That(exception.Message,
                Does.StartWith($"merge: {missing} of {all} runs are in no shard: {one}").And
                    .Contain($"({missing} of shard 2/3, which is not among the folders)"));
            Assert.That(charts.Lines("merged", "accuracy.csv"), Has.Length.EqualTo(1 + 2 * (all - missing)));
            Assert.That(File.Exists(Path.Combine(charts.Folder("merged"), "accuracy.gp")), Is.True);
        }

        [Test]
        public void AShardThatStoppedEarlyIsNamed()
        {
            charts.Measure("1", "--shard", "1/2");
            using (ChartSession session = charts.Create("2", "--shard", "2/2"))
            {
                for (int i = 0; i < 4; i++) session.Step();
            }
            // The line of a run that was being written when the machine went down.
            string runs = Path.Combine(charts.Folder("2"), "shard-runs.csv");
            string[] finished = File.ReadAllLines(runs);
            Assert.That(finished, Has.Length.GreaterThan(1));
            File.WriteAllLines(runs, finished.Take(finished.Length - 1));
            var exception = Assert.Throws<IncompleteException>(() => charts.Merge("merged", "1", "2"));

            Assert.That(exception.Message, Does.Contain($"of shard 2/2, which stopped early in '{charts.Folder("2")}'"));
            Assert.That(charts.Said, Has.Some.Contain("was stopped within " + CsvText.Split(finished.Last())[0]));
        }

        [Test]
        public void ARunOfTwoShardsIsSaidWhenItIsEqual()
        {
            charts.MeasureAll(2);
            charts.Slowness = 2.0;
            charts.Measure("first-of-3", "--shard", "1/3");
            charts.Merge("merged", "first-of-3", "1", "2");
            int repeated = charts.Lines("first-of-3", "shard-runs.csv").Length - 1;

            Assert.That(charts.Said, Has.Some.StartWith($"{repeated} of them are in more than one shard, with equal results"));
            Assert.That(charts.Lines("merged", "accuracy.csv"),
                Has.Length.EqualTo(1 + 2 * (charts.Lines("1", "shard-plan.csv").Length - 1)));
        }

        [Test]
        public void ARunOfTwoShardsIsRefusedWhenItIsNot()
        {
            charts.MeasureAll(2);
            Func<ChartRun, double> error = charts.Error;
            charts.Error = run => 1.001 * error(run);
            charts.Measure("again", "--shard", "1/2");

            string message = Expect("both have the run accuracy.csv|ellipsoid|standard|", "merged", "1", "2", "again");
            Assert.That(message,
                Does.Contain("with unequal results: error is '").And.Contain(charts.Folder("1")).And.Contain(charts.Folder("again")));
            Assert.That(Directory.Exists(charts.Folder("merged")), Is.False, "nothing is written");
        }

        [Test]
        public void AnotherDeviceIsRefusedButForErrors()
        {
            charts.Measure("1", "--shard", "1/2");
            charts.Device = "another";
            charts.Measure("2", "--shard", "2/2");

            Expect(
                $"'{charts.Folder("2")}' is not of the same sweep as '{charts.Folder("1")}': its device is 'another', not 'a device'. " +
                "Times of unlike devices do not compare; " +
                "--errors-only merges all but the times.", "merged", "1", "2");
            charts.Merge("merged", "1", "2", "--errors-only");
            Func<ChartRow> create = () => new ChartRow();
            List<ChartRow> rows = ChartRow.Format.ReadAll(Path.Combine(charts.Folder("merged"), "accuracy.csv"), create);

            Assert.That(rows.Select(r => r.Device).Distinct(), Is.EquivalentTo(new[] { "a device", "another" }));
            Assert.That(rows.Select(r => r.GpuMsPerSecond).Concat(rows.Select(r => r.CpuMsPerSecond)), Is.All.NaN);
            Assert.That(rows.Select(r => r.Error), Has.None.NaN);
            Assert.That(File.Exists(Path.Combine(charts.Folder("merged"), "accuracy.gp")), Is.False);
            Assert.That(charts.Said, Has.Some.Contain("without times"));
        }

        [Test]
        public void AnotherCommitIsRefused()
        {
            Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, "1111111");
            charts.Measure("1", "--shard", "1/2");
            Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, "");
            charts.Measure("2", "--shard", "2/2");

            Expect($"its program is 'version {SweepBuild.Version}, assemblies {SweepBuild.Assemblies}', not 'commit 1111111'.",
                "merged", "1", "2");
        }

        [Test]
        public void AnotherCommandIsRefused()
        {
            charts.Measure("1", "--shard", "1/2");
            charts.Measure("2", "--shard", "2/2", "--case", "couette");

            Expect(
                "its command is 'chart --quick --case ellipsoid couette --method standard', not 'chart --quick --case ellipsoid --method " +
                "standard'", "merged", "1", "2");
        }

        [Test]
        public void ABrokenShardIsNamed()
        {
            charts.MeasureAll(2);
            string plan = Path.Combine(charts.Folder("2"), "shard-plan.csv"), table = Path.Combine(charts.Folder("1"), "accuracy.csv");
            File.WriteAllLines(plan, File.ReadAllLines(plan).Reverse().Skip(1).Reverse());
            Expect($"'{charts.Folder("2")}' cannot be merged: its shard-plan.csv was changed", "merged", "1", "2");
            File.AppendAllText(table, "ellipsoid,standard\n");
            Expect($"'{charts.Folder("1")}' cannot be merged: its accuracy.csv has a broken line", "merged", "1");
        }

        [Test]
        public void AFolderWithoutAShardIsNamed()
        {
            charts.Measure("whole");

            Expect($"'{charts.Folder("whole")}' cannot be merged: it has no shard.csv", "merged", "whole");
            Expect("is no folder", "merged", "nothing");
            Expect("name the folders of the shards", "merged");
        }

        [Test]
        public void FoldersOfOthersAreNotWrittenTo()
        {
            charts.MeasureAll(2);
            charts.Measure("whole");

            Expect("is named twice", "merged", "1", "1");
            Expect("is one of the shards", "2", "1", "2");
            Expect("holds accuracy.csv, which no merge wrote. Name another folder.", "whole", "1", "2");
        }

        private string Expect(string message, string name, params string[] words)
        {
            var exception = Assert.Throws<CommandLineException>(() => charts.Merge(name, words));
            Assert.That(exception.Message, Does.Contain(message).And.Not.Contain("\n"));
            return exception.Message;
        }
    }
}
