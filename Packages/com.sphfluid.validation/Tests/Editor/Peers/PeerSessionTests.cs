using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The order of the runs and what is written, with runs that are made up.</summary>
    public sealed class PeerSessionTests
    {
        private readonly List<string> said = new List<string>();
        private readonly List<PeerPoint> done = new List<PeerPoint>();
        private string folder, failure;

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
        public void EveryRunHasItsLinesAndIsComparedWithAChart()
        {
            Finish(Create("--case", "hydrostatic", "couette", "dam-break"));

            // Half of the resolution and the case's own; where the case's speed of sound is another one, the finer of them twice.
            Assert.That(done.Select(p => (p.Peer.Case.Name, p.Parameters.Resolution, p.Parameters.SoundSpeedRatio)), Is.EqualTo(new[]
            {
                ("hydrostatic", 10, 10.0), ("hydrostatic", 10, 6.0), ("couette", 8, 10.0), ("couette", 16, 10.0), ("dam-break", 8, 10.0),
                ("dam-break", 16, 10.0),
                ("dam-break", 16, 5.0),
            }));
            Assert.That(Lines("peers.csv"), Has.Length.EqualTo(1 + 2 * 7), "two errors each");
            Assert.That(Lines("peers-compared.csv").Skip(1),
                Has.Exactly(7).Contains("pysph-").And.Exactly(1).Contains("couette,standard,0.0625,10,784,0.02,"));
            Assert.That(said, Has.Some.Contains("7/7  dam-break, pysph-wcsph").And.Contains("1,500 ms by the clock"));
            string script = File.ReadAllText(Path.Combine(folder, "peers.gp"));
            Assert.That(script, Does.Contain("pysph-wcsph, c = 10 U").And.Contain("pysph-wcsph, c = 5 U").And.Contain("title 'standard'"));
        }

        [Test]
        public void GoesOnWhereItWasStopped()
        {
            Finish(Create("--quick", "--case", "couette"));
            Finish(Create("--quick", "--case", "couette", "marin"));

            Assert.That(done.Select(p => p.Peer.Case.Name), Is.EqualTo(new[] { "couette", "marin" }));
            Assert.That(said, Has.Some.Contains("1 of them are there already"));
            Assert.That(Lines("peers.csv"), Has.Length.EqualTo(1 + 2 * 2));
        }

        [Test]
        public void AFailedRunIsKeptWithItsReason()
        {
            failure = "particle 3 is gone";
            Finish(Create("--quick", "--case", "couette"));

            Assert.That(Lines("peers.csv").Skip(1).Single(), Does.Contain(",1,particle 3 is gone,"));
            Assert.That(said, Has.Some.Contains("failed: particle 3 is gone"));
            Assert.That(Lines("peers-compared.csv")[1], Does.StartWith("couette,pysph-tvf,0.125,10,").And.Contain(",,"));
        }

        [Test]
        public void WithoutAChartTheRunsAreThere()
        {
            Finish(new PeerSession(Arguments("--quick", "--case", "couette"), Run, Progress, "processor",
                () => throw new CommandLineException("There is no chart.")));

            Assert.That(Lines("peers.csv"), Has.Length.EqualTo(3));
            Assert.That(said, Has.Some.EqualTo("There is no chart. Without a chart nothing is compared; peers.csv has all runs."));
            Assert.That(File.Exists(Path.Combine(folder, "peers-compared.csv")), Is.False);
        }

        [Test]
        public void RunsOfAnotherProcessorAreRefused()
        {
            Finish(Create("--quick", "--case", "couette"));
            Assert.That(() => new PeerSession(Arguments(), Run, Progress, "another one", Chart),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("'another one'"));
        }

        [Test]
        public void EveryCaseIsMadeAtAllOfItsPoints()
        {
            foreach (PeerPoint point in PeerCase.All.SelectMany(c => c.Points(false)))
            {
                Assert.That(point.Setup.Particles.Length, Is.GreaterThan(100), $"{point}");
            }
            Assert.That(PeerCase.All.SelectMany(c => c.Points(false)).Select(p => p.Key), Is.Unique);
        }

        private PeerSession Create(params string[] words) => new PeerSession(Arguments(words), Run, Progress, "processor", Chart);

        private SessionProgress Progress => new SessionProgress(said.Add, null);

        private PeerArguments Arguments(params string[] words) =>
            PeerArguments.Parse(new[] { "player", "--", "--out", folder }.Concat(words).ToArray());

        private static ChartData Chart()
        {
            ValidationCase couette = PeerCase.All.First(c => c.Case.Name == "couette").Case;
            var config = new ChartConfig(couette, couette.Base(CaseMethod.Find("standard")), ChartFactor.Base);
            var rows = new ChartRows("llvmpipe");
            rows.Add(new ChartRun(config, 1),
                new CaseResult { Errors = new[] { new CaseError(couette.ErrorName, 0.02) }, GpuMsPerSecond = 24.0 }, "2026-11-25");
            return new ChartData("made up", rows.Rows, Array.Empty<StepCostRow>());
        }

        private static void Finish(PeerSession session)
        {
            using (session)
            {
                while (session.Step())
                {
                }
            }
        }

        private IEnumerator Run(PeerPoint point, Action<PeerRow[]> hand)
        {
            yield return null;
            done.Add(point);
            var result = new CaseResult { Failure = failure, Particles = point.Setup.Particles.Length };
            if (failure == null) result.Errors = new[] { new CaseError(point.Peer.Case.ErrorName, 0.01), new CaseError("other", 2.0) };
            var facts = new PeerFacts { Version = "PySPH 1", Steps = 10, End = 2.0, SupportRatio = 3.0, Evaluations = 1 };
            hand(PeerRow.Of(point, facts, StepTimes.Of(new[] { 300.0 }, new[] { 1 }), result));
        }

        private string[] Lines(string file) => File.ReadAllLines(Path.Combine(folder, file));
    }
}
