using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The order of a chart's work, with runs that are made up.</summary>
    public sealed class ChartSessionTests
    {
        private static readonly ValidationCase[] cases = { new FlatCase("one", 6), new FlatCase("two", 6) };

        private readonly List<string> said = new List<string>();
        private readonly List<ChartRun> done = new List<ChartRun>();
        private string folder, failure;
        private ChartPlan lastPlan;

        [SetUp]
        public void SetUp()
        {
            said.Clear();
            done.Clear();
            failure = null;
            folder = TestFolder.Fresh();
        }

        [TearDown]
        public void TearDown() => TestFolder.Delete(folder);

        [Test]
        public void WritesEveryRunAndTheFilesAtTheEnd()
        {
            ChartPlan plan = Finish(Create());

            Assert.That(done.Select(r => r.ToString()), Is.EqualTo(plan.Runs.Select(r => r.ToString())));
            Assert.That(Lines("accuracy.csv"), Has.Length.EqualTo(1 + 2 * plan.Runs.Count), "two errors each");
            Assert.That(Lines("pareto.csv"), Has.Length.GreaterThan(1));
            foreach (string file in new[] { "accuracy.gp", "case-one.gp", "case-two.gp", "curves/one.thesis.csv", "report.html" })
            {
                Assert.That(File.Exists(Path.Combine(folder, file)), Is.True, file);
            }
            Assert.That(said, Has.Some.Contains($"1/{plan.Runs.Count}  one, thesis"));
            Assert.That(said.Last(), Does.Contain($"All {plan.Runs.Count} runs are done"));
        }

        [Test]
        public void GoesOnWhereItWasStopped()
        {
            using (ChartSession session = Create())
            {
                for (int i = 0; i < 4; i++) session.Step();
            }
            int first = done.Count;
            Assert.That(first, Is.GreaterThan(0));
            Assert.That(said.Last(), Does.StartWith("Stopped early.").And.Contain("the same command"));
            Assert.That(Lines("accuracy.csv"), Has.Length.GreaterThanOrEqualTo(1 + 2 * (first - 1)));

            ChartPlan plan = Finish(Create());

            Assert.That(done.Skip(first).Select(r => r.ToString()).Intersect(Finished(first)), Is.Empty, "done twice");
            Assert.That(done.Select(r => r.ToString()).Distinct().Count(), Is.EqualTo(plan.Runs.Count));
            Assert.That(said, Has.Some.Contains("are there already"));
            done.Clear();
            Finish(Create());
            Assert.That(done, Is.Empty);
        }

        [Test]
        public void ARunOfAnotherNumberOfParticlesIsDoneAgainAndReplaced()
        {
            Finish(Create());
            string file = Path.Combine(folder, "accuracy.csv"), all = File.ReadAllText(file);
            string changed = all.Replace($",{done[0].Config.Particles},1,", $",{done[0].Config.Particles - 1},1,");
            Assert.That(changed, Is.Not.EqualTo(all));
            File.WriteAllText(file, changed);
            int lines = Lines("accuracy.csv").Length;
            done.Clear();
            Finish(Create());

            Assert.That(done, Is.Not.Empty);
            Assert.That(Lines("accuracy.csv"), Has.Length.EqualTo(lines));
            Assert.That(Lines("accuracy.csv").Where(l => l.Contains($",{done[0].Config.Particles - 1},1,")), Is.Empty);
        }

        [Test]
        public void ASliceStopsBetweenTwoRunsAndSaysHowToGoOn()
        {
            // A run longer than the slice is begun only as the slice's first.
            ChartPlan plan = Finish(Create(new SessionRate(1e-3), "--slice", "0.000001"));

            Assert.That(done, Has.Count.EqualTo(1));
            Assert.That(said.Last(), Does.Contain($"1 of {plan.Runs.Count} runs").And.Contain("The same command goes on"));
            Assert.That(File.Exists(Path.Combine(folder, "accuracy.gp")), Is.True, "drawn with what there is");
        }

        [Test]
        public void PointsThatCannotBeSetUpAreOneLine()
        {
            var small = new[] { new FlatCase("small", 6) { SupportLimit = 2.4 } };
            ChartArguments arguments = ChartArguments.Parse(new[] { "player", "--", "--method", "standard", "--out", folder }, small);
            lastPlan = ChartPlan.Full(arguments.Cases, arguments.Methods);
            Assert.That(lastPlan.Unbuildable, Has.Count.GreaterThan(1));
            Finish(new ChartSession(arguments, lastPlan, Run, new SessionProgress(said.Add, null), "device", new SessionRate(null)));

            Assert.That(said.Where(l => l.Contains("Not part of the chart")), Is.EqualTo(new[]
                { $"Not part of the chart: {lastPlan.Unbuildable.Count} points of small with standard: the cube is too small for κ" }));
        }

        [Test]
        public void FailedRunsAreKeptWithTheirReason()
        {
            failure = "energy grew to 1.3 times its start";
            ChartPlan plan = Finish(Create());

            Assert.That(Lines("accuracy.csv").Skip(1).Count(l => l.Contains(",1," + failure + ",")), Is.EqualTo(plan.Runs.Count));
            Assert.That(said, Has.Some.Contains("failed: " + failure));
            Assert.That(Lines("pareto.csv"), Has.Length.EqualTo(1));
        }

        private ChartSession Create(params string[] words) => Create(new SessionRate(null), words);

        private ChartSession Create(SessionRate rate, params string[] words)
        {
            var line = new List<string> { "player", "--", "--method", "thesis", "--out", folder };
            line.AddRange(words);
            ChartArguments arguments = ChartArguments.Parse(line, cases);
            lastPlan = ChartPlan.Quick(arguments.Cases, arguments.Methods, double.PositiveInfinity);
            return new ChartSession(arguments, lastPlan, Run, new SessionProgress(said.Add, null), "device", rate);
        }

        private ChartPlan Finish(ChartSession session)
        {
            using (session)
            {
                while (session.Step())
                {
                }
            }
            return lastPlan;
        }

        // Two frames a run.
        private IEnumerator Run(ChartRun run, Action<CaseResult> hand)
        {
            yield return null;
            yield return null;
            done.Add(run);
            double gpu = 1e4 * run.Config.Particles / 216.0, error = 0.1 * 6.0 * run.Config.Spacing / run.Config.SupportRatio;
            hand(FlatCase.Result(gpu * (1.0 + 0.01 * run.Seed), error * (1.0 + 0.01 * run.Seed), failure));
        }

        private string[] Lines(string file) => File.ReadAllLines(Path.Combine(folder, file));

        private IEnumerable<string> Finished(int count) => done.Take(count).Select(r => r.ToString());
    }
}
