using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>What a shard does and leaves in its folder, with runs that are made up.</summary>
    public sealed class ShardFolderTests
    {
        private ShardedCharts charts;

        [SetUp]
        public void SetUp() => charts = new ShardedCharts();

        [TearDown]
        public void TearDown() => charts.Dispose();

        [Test]
        public void ShardsDoTheRunsOfTheWholeOnceEach([Values(1, 2, 3, 60)] int shards)
        {
            charts.Measure("whole");
            string[] whole = charts.Done.ToArray();
            charts.Done.Clear();
            charts.MeasureAll(shards);

            Assert.That(whole, Has.Length.GreaterThan(3).And.Length.LessThan(60));
            Assert.That(charts.Done, Is.EquivalentTo(whole));
        }

        [Test]
        public void ItLeavesWhatItIsAPartOf()
        {
            charts.Measure("2", "--shard", "2/3");
            string[] manifest = CsvText.Split(charts.Lines("2", "shard.csv")[1]);
            string[] plan = charts.Lines("2", "shard-plan.csv");
            string[] own = plan.Skip(1).Select(CsvText.Split).Where(c => c[2] == "2").Select(c => c[0]).ToArray();

            Assert.That(manifest.Take(4), Is.EqualTo(new[] { "chart", "chart --quick --case ellipsoid --method standard", "2", "3" }));
            Assert.That(manifest, Does.Contain((plan.Length - 1).ToString()).And.Contain("a device"));
            Assert.That(own, Is.Not.Empty);
            Assert.That(charts.Done.Select(k => "accuracy.csv|" + k), Is.EqualTo(own));
            Assert.That(charts.Lines("2", "shard-runs.csv").Skip(1).Select(l => CsvText.Split(l)[0]), Is.EqualTo(own));
            Assert.That(charts.Lines("2", "accuracy.csv"), Has.Length.EqualTo(1 + 2 * own.Length));
            Assert.That(File.Exists(Path.Combine(charts.Folder("2"), "accuracy.gp")), Is.False, "a part is not drawn");
            Assert.That(charts.Said.Last(), Does.StartWith($"All {own.Length} runs of shard 2/3 are done"));
        }

        [Test]
        public void ItGoesOnWhereItWasStopped()
        {
            using (ChartSession session = charts.Create("1", "--shard", "1/2"))
            {
                for (int i = 0; i < 4; i++) session.Step();
            }
            int first = charts.Done.Count;
            charts.Measure("1", "--shard", "1/2");

            Assert.That(first, Is.GreaterThan(0));
            Assert.That(charts.Done, Is.Unique);
            Assert.That(charts.Lines("1", "shard-runs.csv"), Has.Length.EqualTo(1 + charts.Done.Count));
        }

        [Test]
        public void AnotherShardOfTheFolderIsRefused()
        {
            charts.Measure("1", "--shard", "1/2");

            Expect(
                "holds shard 1/2 of 'chart --quick --case ellipsoid --method standard', and this is shard 2/2. Give each shard a folder " +
                "of its own.", "1", "--shard", "2/2");
            Expect("Go on with --shard 1/2, or name another folder.", "1");
            Expect(
                "holds a shard of another command: 'chart --quick --case ellipsoid --method standard', and this is 'chart --quick --case " +
                "ellipsoid jet --method standard'",
                "1", "--shard", "1/2", "--case", "jet");
        }

        [Test]
        public void AnotherDevicesShardIsRefused()
        {
            charts.Measure("1", "--shard", "1/2");
            charts.Device = "another";

            Expect("this is 'another'", "1", "--shard", "1/2");
        }

        [Test]
        public void ResultsOfNoShardStayAlone()
        {
            charts.Measure("whole");

            Expect("holds accuracy.csv, which no shard wrote. Name another folder.", "whole", "--shard", "1/2");
        }

        [Test]
        public void AnotherCommitsShardIsRefused()
        {
            string before = Environment.GetEnvironmentVariable(SweepBuild.CommitVariable);
            try
            {
                Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, "1111111");
                charts.Measure("1", "--shard", "1/2");
                Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, "2222222");

                Expect("holds a shard of another program: 'commit 1111111', and this is 'commit 2222222'", "1", "--shard", "1/2");
            }
            finally
            {
                Environment.SetEnvironmentVariable(SweepBuild.CommitVariable, before);
            }
        }

        [Test]
        public void AManifestThatWasChangedIsRefused()
        {
            charts.Measure("1", "--shard", "1/2");
            string file = Path.Combine(charts.Folder("1"), "shard.csv");
            File.WriteAllText(file, File.ReadAllText(file).Replace(",1,2,", ",3,2,"));

            Expect("does not have one line that names a shard. Name another folder, or move the file away.", "1", "--shard", "1/2");
        }

        private void Expect(string message, string name, params string[] words) =>
            Assert.That(() => charts.Create(name, words), Throws.TypeOf<CommandLineException>().With.Message.Contains(message));
    }
}
