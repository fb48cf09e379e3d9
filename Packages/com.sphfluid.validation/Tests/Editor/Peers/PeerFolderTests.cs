using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Cases go to another program's folder, and its states give a metric what states in memory give it.</summary>
    public sealed class PeerFolderTests
    {
        private PeerFolder folder;

        private static IEnumerable<string> Names => PeerCase.All.Select(c => c.Case.Name);

        [SetUp]
        public void SetUp() => folder = new PeerFolder();

        [TearDown]
        public void TearDown() => folder.Dispose();

        [TestCaseSource(nameof(Names))]
        public void ACaseIsWrittenWithItsParticles(string name)
        {
            PeerPoint point = PeerRig.Point(name, 11);
            folder.Write(point);

            FluidParticle[] particles = point.Setup.Particles;
            float[,] start = NpyFile.Read(folder.PathOf("start.npy"), 8);
            Assert.That(start.GetLength(0), Is.EqualTo(particles.Length));
            int last = particles.Length - 1;
            Assert.That(new Vector3(start[last, 0], start[last, 1], start[last, 2]), Is.EqualTo(particles[last].Position));
            Assert.That(new Vector3(start[last, 3], start[last, 4], start[last, 5]), Is.EqualTo(particles[last].VelT0));
            string json = File.ReadAllText(folder.PathOf("case.json"));
            Assert.That(json, Does.Contain($"\"case\": \"{name}\""));
            Assert.That(Number(json, "soundSpeed"),
                Is.EqualTo(10.0 * point.Setup.Settings.MaxSpeed).Within(1e-5 * point.Setup.Settings.SoundSpeed));
            Assert.That(Number(json, "duration"), Is.EqualTo(point.Setup.Duration).Within(1e-9));
        }

        [Test]
        public void WhatACaseHasIsInItsFile()
        {
            string couette = Json("couette"), poiseuille = Json("poiseuille"), drop = Json("ellipsoid"), marin = Json("marin");

            Assert.That(Number(couette, "viscosity"), Is.EqualTo(0.01).Within(1e-8));
            Assert.That(couette, Does.Contain("\"high\": [0.1"), "the upper wall moves");
            Assert.That(poiseuille, Does.Contain("\"gravity\": [0.008"));
            Assert.That(poiseuille, Does.Contain("\"periodic\": [1,0,1]"));
            Assert.That(drop, Does.Contain("\"walls\": []").And.Contain("\"centralForce\": [1,1,1]"));
            Assert.That(Regex.Matches(marin, "\"centre\"").Count, Is.EqualTo(2), "patches");
            Assert.That(marin, Does.Match(@"""obstacles"": \[\{\s*""low"": \[-0\.94"));
        }

        [TestCase("hydrostatic", 1)]
        [TestCase("dam-break", 2)]
        public void AColumnAtRestHasItsWholeMass(string name, int layers)
        {
            // The integral of the density over the height is ρ0 times the height of the lattice.
            PeerPoint point = PeerRig.Point(name, 20, 3.0);
            CaseSetup setup = point.Setup;
            double depth = layers * 20 * setup.Settings.Spacing, floor = -0.5 * setup.Settings.DomainSize.y;
            double m = 9.0 * setup.Settings.MaxSpeed * setup.Settings.MaxSpeed / (9.81 * depth),
                height = WallCaseSetup.Settled(depth, depth, m);
            const int Parts = 500;
            double mean = Enumerable.Range(0, Parts).Average(i =>
                point.Peer.DensityAt(setup, 20, new Vector3(0f, (float)(floor + (i + 0.5) * height / Parts), 0f)));

            Assert.That(height, Is.LessThan(0.99 * depth));
            Assert.That(mean * height, Is.EqualTo(setup.Settings.RestDensity * depth).Within(1e-5 * setup.Settings.RestDensity * depth));
        }

        [TestCase("ellipsoid")]
        [TestCase("marin")]
        public void WhereNothingPressesAtTheStartTheDensityIsThatAtRest(string name)
        {
            PeerPoint point = PeerRig.Point(name, 5);
            Assert.That(point.Peer.DensityAt(point.Setup, 5, point.Setup.Particles[0].Position),
                Is.EqualTo(point.Setup.Settings.RestDensity));
        }

        [TestCase("couette", 4)]
        [TestCase("couette", 5)]
        [TestCase("marin", 4)]
        public void AMetricGivesTheSameErrorsAsInMemory(string name, int resolution)
        {
            PeerPoint point = PeerRig.Point(name, resolution);
            CaseSetup setup = point.Setup;
            double[] times = PeerRig.Times(setup).ToArray();
            float[,] At(double time) => PeerRig.State(setup, p => new Vector3(0.01f * p.y + 1e-4f * (float)time, 0.001f * p.x, 0f));
            PeerRig.WriteSamples(folder, times, At);

            CaseResult read = PeerSample.Evaluate(setup, Metric(point), folder.ReadSamples(setup));
            CaseResult memory = PeerSample.Evaluate(setup, Metric(point), times.Select(t => new PeerSample(t, PeerRig.Snapshot(At(t)))));

            Assert.That(read.Failure, Is.Null);
            Assert.That(read.Errors.Select(e => (e.Name, e.Value)), Is.EqualTo(memory.Errors.Select(e => (e.Name, e.Value))));
            Assert.That(read.Errors[0].Value, Is.GreaterThan(0.0));
        }

        // A column that stands still fits at no shift in time.
        [Test]
        public void AFitThatEndsAtItsBoundIsAPeersFailureToo()
        {
            PeerPoint point = PeerRig.Point("dam-break", 4);
            PeerRig.WriteSamples(folder, PeerRig.Times(point.Setup).ToArray(), _ => PeerRig.State(point.Setup, p => Vector3.zero));

            CaseResult read = PeerSample.Evaluate(point.Setup, Metric(point), folder.ReadSamples(point.Setup));

            Assert.That(read.Failure, Does.StartWith("dam-break: the front's shift in T"));
            Assert.That(read.Errors, Is.Empty);
        }

        [Test]
        public void PressuresOfPatchesReachTheMetric()
        {
            PeerPoint point = PeerRig.Point("marin", 4);
            double[] times = PeerRig.Times(point.Setup).ToArray();
            PeerRig.WriteSamples(folder, times, _ => PeerRig.State(point.Setup, p => Vector3.zero));
            var pressures = new float[times.Length, 2];
            for (int i = 0; i < times.Length; i++)
            {
                (pressures[i, 0], pressures[i, 1]) = i == 0 ? (float.NaN, float.NaN)
                    : (2f * (float)MarinPressures.Front[Math.Min(i, 120) - 1], 0f);
            }
            NpyFile.Write(folder.PathOf("pressures.npy"), pressures);

            CaseResult result = PeerSample.Evaluate(point.Setup, Metric(point), folder.ReadSamples(point.Setup));

            double front = result.Errors.First(e => e.Name.StartsWith("impulse on the front", StringComparison.Ordinal)).Value;
            double top = result.Errors.First(e => e.Name.StartsWith("impulse on the top", StringComparison.Ordinal)).Value;
            Assert.That(front, Is.EqualTo(1.0).Within(0.01), "twice the record");
            Assert.That(top, Is.EqualTo(-1.0).Within(1e-6), "nothing");
        }

        [Test]
        public void AStateThatIsNoLiquidEndsTheRun()
        {
            PeerPoint point = PeerRig.Point("couette", 4);
            PeerRig.WriteSamples(folder, new[] { 0.0, 2.0, 4.0 },
                t => PeerRig.State(point.Setup, p => new Vector3(t == 2.0 ? float.NaN : 0f, 0f, 0f)));

            CaseResult result = PeerSample.Evaluate(point.Setup, Metric(point), folder.ReadSamples(point.Setup));

            Assert.That(result.Failure, Does.StartWith("particle 0 is at").And.EndWith("at 2 s"));
            Assert.That(result.Errors, Is.Empty);
        }

        [Test]
        public void WhatIsMissingOrAnotherIsNamed()
        {
            PeerPoint point = PeerRig.Point("couette", 4), other = PeerRig.Point("couette", 5);
            Refuses(() => folder.ReadSamples(point.Setup).ToList(), "samples.csv' is missing");
            Refuses(() => folder.ReadFacts(), "run.csv' is missing");
            PeerRig.WriteSamples(folder, new[] { 0.0 }, _ => PeerRig.State(other.Setup, p => p));
            Refuses(() => folder.ReadSamples(point.Setup).ToList(),
                $"has {other.Setup.Particles.Length} particles instead of {point.Setup.Particles.Length}");
            File.Delete(folder.PathOf("sample-00000.npy"));
            Refuses(() => folder.ReadSamples(point.Setup).ToList(), "sample-00000.npy' is missing");
            File.WriteAllText(folder.PathOf("run.csv"), "version\n");
            Refuses(() => folder.ReadFacts(), "does not have the columns of run.csv");
            File.WriteAllText(folder.PathOf("run.csv"), PeerFacts.Format.FirstLine + "\n");
            Refuses(() => folder.ReadFacts(), "has 0 lines instead of one");
        }

        [Test]
        public void FactsAreRead()
        {
            File.WriteAllText(folder.PathOf("run.csv"), PeerFacts.Format.FirstLine + "\nPySPH 1.0b1,2.6,301,2,400,0.5,21.25,\n");
            PeerFacts facts = folder.ReadFacts();

            Assert.That(facts.TimeStep, Is.EqualTo(0.00125).Within(1e-12));
            Assert.That((facts.Version, facts.BoundaryParticles, facts.Evaluations), Is.EqualTo(("PySPH 1.0b1", 301L, 2L)));
            Assert.That(facts.OtherCores, Is.NaN);
        }

        [Test]
        public void AMomentOfABusyMachineDoesNotMoveTheTime()
        {
            // Twenty samples of ten steps of 2 ms each; three of the stretches between them took five times as long.
            IEnumerable<string> lines = Enumerable.Range(0, 21).Select(i =>
                FormattableString.Invariant($"{0.1 * i},sample-{i:00000}.npy,{10 * i},{0.02 * i + 0.08 * Math.Min(3, i)}"));
            File.WriteAllLines(folder.PathOf("samples.csv"), lines.Prepend("time_s,file,steps,wall_s"));
            StepTimes times = folder.ReadTimes();

            Assert.That(times.Median, Is.EqualTo(2.0).Within(1e-6));
            Assert.That(times.Mean, Is.EqualTo((20 * 20.0 + 3 * 80.0) / 200.0).Within(1e-6));
        }

        [Test]
        public void ItIsGoneInTheEnd()
        {
            folder.Write(PeerRig.Point("couette", 4));
            folder.Dispose();
            Assert.That(Directory.Exists(folder.Name), Is.False);
        }

        private static CaseMetric Metric(PeerPoint point) => point.Peer.Case.CreateMetric(point.Parameters, point.Setup);

        private string Json(string name)
        {
            using (var own = new PeerFolder())
            {
                own.Write(PeerRig.Point(name, 5));
                return File.ReadAllText(own.PathOf("case.json"));
            }
        }

        private static double Number(string json, string key) =>
            double.Parse(Regex.Match(json, $"\"{key}\": ([^,]+),").Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture);

        private static void Refuses(TestDelegate read, string problem) =>
            Assert.That(read, Throws.TypeOf<InvalidDataException>().With.Message.Contains(problem));
    }
}
