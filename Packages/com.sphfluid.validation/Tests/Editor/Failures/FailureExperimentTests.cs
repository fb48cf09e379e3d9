using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Each failure mode of Documentation~/failure-modes.md: the failing run is named by its detector, the cured one is not, and the
    /// figures part.
    /// </summary>
    public sealed class FailureExperimentTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = FailureShaders.Create();

        [TearDown]
        public void DestroyShaders() => Object.DestroyImmediate(shaders);

        [Test]
        public void EveryFailureHasOneExperiment()
        {
            // Consequences of the others have none of their own.
            var consequences = new[] { FluidFailure.NonFinite, FluidFailure.EnergyGrowth, FluidFailure.Escaped };
            FluidFailure[] expected = System.Enum.GetValues(typeof(FluidFailure)).Cast<FluidFailure>().Except(consequences).ToArray();
            Assert.That(FailureCatalogue.All().Select(e => e.Failure), Is.EquivalentTo(expected));
            Assert.That(FailureCatalogue.All().Select(e => e.Name), Is.Unique);
        }

        // Fewer steps than the page's where the figure is there before. FailureFigureTests has the time step, at its border.
        [TestCase("tensile-clumping", 0.3, 0.8, 0.0, 0.0, 60)]
        [TestCase("pairing", 0.8, 1.0, 0.0, 0.4, 100)]
        [TestCase("kernel-mismatch", 0.03, 0.2, 0.0, 0.003, 200)] // on its way to what the whole run has
        [TestCase("density-deficiency", -0.72, -0.68, 0.0, 0.0)] // 2 (0.65 − 1), k = 2 c²
        [TestCase("self-term", 0.805, 0.82, 1.0, 1.02)]
        [TestCase("coincident", 0.5, 7.0, 0.5, 7.0)]
        [TestCase("viscosity", 100.0, 1e9, 0.0, 1.05, 70)]
        [TestCase("numerical-viscosity", 1e4, 3e4, 0.85, 1.1)]
        [TestCase("tunnelling", 0.2, 1.0, 0.0, 0.0)]
        [TestCase("wall-stacking", 0.1, 1.0, 0.0, 0.0, 120)]
        [TestCase("clamp", 0.01, 1.0, 0.0, 1e-7)]
        [TestCase("overflow", 150.0, 200.0, 26.0, 40.0)]
        [TestCase("overlapping-start", 0.3, 2.0, 0.0, 0.05)]
        [TestCase("asymmetric-pairs", 0.1, 0.2, 0.0, 0.0)]
        [TestCase("stale-grid", 0.05, 0.3, 0.0, 0.0)]
        public void TheFailingRunIsNamedAndTheCuredIsNot(string name, double failingLow, double failingHigh, double curedLow,
            double curedHigh, int steps = 0)
        {
            FailureExperiment experiment = FailureCatalogue.Find(name);
            if (steps > 0) experiment.Failing.Steps = experiment.Cured.Steps = steps;
            Check(experiment, failingLow, failingHigh, curedLow, curedHigh);
        }

        [TestCase("tensile-clumping", 0.3, 0.8, 0.0, 0.0)]
        [TestCase("pairing", 0.8, 1.0, 0.0, 0.4)]
        [TestCase("kernel-mismatch", 0.30, 0.40, 0.0, 0.003)] // research: 0.34 to 0.37, and 0.003 with ν = 0.02 c R
        [TestCase("time-step", 0.2, 10.0, 0.0, 0.02)]
        [TestCase("viscosity", 100.0, 1e9, 0.0, 1.05)]
        [TestCase("deep-tank", 0.88, 0.92, 0.955, 0.985)]
        [Explicit("The page's own figures: a minute.")]
        public void SoTheyAreInTheWholeRun(string name, double failingLow, double failingHigh, double curedLow, double curedHigh) =>
            Check(FailureCatalogue.Find(name), failingLow, failingHigh, curedLow, curedHigh);

        // One period of the column's slowest wave in place of two.
        [Test]
        public void ADeepColumnStandsAsTheEquationOfStateHasIt()
        {
            FailureExperiment experiment = FailureCatalogue.Find("deep-tank");
            experiment.Failing.Steps /= 2;
            experiment.Cured.Steps /= 2;
            (double soft, double stiff) = Check(experiment, 0.88, 0.92, 0.955, 0.985);
            double expected = DensityFailures.TheoreticalHeight(5.0), expectedStiff = DensityFailures.TheoreticalHeight(25.0);
            Assert.That(expected, Is.EqualTo(0.912).Within(0.001));
            Assert.That(soft / stiff, Is.EqualTo(expected / expectedStiff).Within(0.01), "both lose the same at floor and surface");
            Assert.That(soft, Is.EqualTo(expected).Within(0.025), "less half a spacing of 24 for floor and surface");
        }

        private (double failing, double cured) Check(FailureExperiment experiment, double failingLow, double failingHigh, double curedLow,
            double curedHigh)
        {
            bool neighbours = experiment.Failure == FluidFailure.AsymmetricPairs || experiment.Failure == FluidFailure.StaleGrid;
            ComputeShader audit = neighbours ? FailureShaders.Audit() : null;

            FailureResult failing = experiment.Run(false, shaders, audit);
            Assert.That(failing.Names(experiment.Failure), Is.True, $"the failing run is named; detectors named {failing.Named}");
            Assert.That(failing.Figure, Is.InRange(failingLow, failingHigh), experiment.Figure);

            FailureResult cured = experiment.Run(true, shaders, audit);
            Assert.That(cured.Names(experiment.Failure), Is.False, $"the cured run is not named; detectors named {cured.Named}");
            Assert.That(cured.Figure, Is.InRange(curedLow, curedHigh), experiment.Figure + ", cured");

            FluidFinding finding = failing.Findings.First(f => f.Failure == experiment.Failure);
            Assert.That(finding.Text, Does.EndWith(".").And.Match("[0-9]"), "a sentence with a figure");
            Assert.That(finding.Cure, Does.EndWith("."), "what to change");
            TestContext.WriteLine($"{experiment.Figure}: {failing.Figure:g4}, cured {cured.Figure:g4}");
            return (failing.Figure, cured.Figure);
        }

        [TestCase("coincident")]
        [TestCase("overflow")]
        public void WhatCannotFailIsSurvivedAndCounted(string name)
        {
            FailureExperiment experiment = FailureCatalogue.Find(name);
            Assert.That(experiment.Survived, Is.True);
            FailureResult stress = experiment.Run(false, shaders);
            Vector3 half = 0.5f * stress.Settings.DomainSize;
            Assert.That(stress.EndStatistics.NonFinite + stress.Counters.NonFinite, Is.Zero, "not finite");
            Assert.That(stress.EndStatistics.ParticleCount, Is.EqualTo(stress.Run.Start.Length));
            Assert.That(stress.End.LocalPositions.All(p => Mathf.Abs(p.x) <= half.x && Mathf.Abs(p.y) <= half.y &&
                Mathf.Abs(p.z) <= half.z), Is.True, "inside");
            Assert.That(stress.End.Ids.Select((id, i) => id == i).All(same => same), Is.True, "every particle once");
            Assert.That(stress.Statistics.Max(v => v.MaxNeighbours), Is.EqualTo(MostNeighbours(stress)), "counted");
        }

        private static int MostNeighbours(FailureResult result) => result.Settings.PeriodLength == Vector3.zero
            ? result.States.Max(s => NeighbourCount.Of(s.LocalPositions, result.Settings.SupportRadius).Maximum)
            : result.States.Max(s => MostAcrossFaces(s.LocalPositions, result.Settings));

        private static int MostAcrossFaces(Vector3[] p, FluidSolverSettings settings)
        {
            var none = new System.Collections.Generic.IReadOnlyList<int>[p.Length];
            for (int i = 0; i < none.Length; i++) none[i] = new int[0];
            NeighbourAudit audit = NeighbourAudit.Of(p, settings.SupportRadius, settings.PeriodLength, none);
            return audit.Missing.GroupBy(e => e.Particle).Max(g => g.Count());
        }
    }
}
