using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class WallImpactMetricTests
    {
        private const double Time = 0.25, Pressure = 6000.0;

        // As samples of a run, not in step with the table.
        private const double Interval = 0.0125;

        [Test]
        public void TheConvergedSolutionHasNoError()
        {
            WallImpactMetric metric = Watched((gauge, t) => At(ConvergedPressure.Pressures, gauge, t));

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new WallImpactCase().ErrorName));
            foreach (CaseError error in metric.Evaluate()) Assert.That(error.Value, Is.Zero.Within(1e-6), error.Name);
        }

        [Test]
        public void TheFloorIsHowFarTheSecondSolverIs()
        {
            WallImpactMetric metric = Watched((gauge, t) => At(ConvergedPressure.SecondSolver, gauge, t));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(new WallImpactCase().Floor).Within(1e-6));
            Assert.That(new WallImpactCase().Floor, Is.InRange(0.02, 0.025));
        }

        [Test]
        public void APressureThatIsTooHighIsFound()
        {
            WallImpactMetric metric = Watched((gauge, t) => 1.25 * At(ConvergedPressure.Pressures, gauge, t));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.25).Within(1e-6));
            Assert.That(WallCaseStates.Named(metric, "pressure at y = 0.27 H, RMS over its own"), Is.EqualTo(0.25).Within(1e-6));
            Assert.That(WallCaseStates.Named(metric, "impulse on the gauges over the converged one − 1"), Is.EqualTo(0.25).Within(1e-6));
            Assert.That(WallCaseStates.Named(metric, "highest mean at y = 0.01 H over the converged one − 1"),
                Is.EqualTo(0.25).Within(1e-6));
        }

        [Test]
        public void WaterThatComesLateIsAnErrorAndNoShiftTakesItOut()
        {
            WallImpactMetric metric = Watched((gauge, t) => At(ConvergedPressure.Pressures, gauge, t - 0.2));

            Assert.That(WallCaseStates.Named(metric, "water comes late, over √(H/g)"), Is.EqualTo(0.2).Within(1e-6));
            Assert.That(metric.Evaluate()[0].Value, Is.GreaterThan(0.1));
        }

        [Test]
        public void ARunThatEndsEarlyHasNoError()
        {
            WallImpactMetric metric = Watched((gauge, t) => 0.0, 5.0);

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
            Assert.That(metric.Series().Count(s => s.IsReference && !s.IsBand), Is.EqualTo(4), "and has a picture");
        }

        [Test]
        public void ExperimentsAreBandsBehindTheirGauges()
        {
            var series = Watched((gauge, t) => At(ConvergedPressure.Pressures, gauge, t)).Series();
            string[] references = series.Where(s => s.IsReference && !s.IsBand).Select(s => s.Name).ToArray();
            CaseSeries[] bands = series.Where(s => s.IsBand).ToArray();

            Assert.That(series.Count(s => !s.IsReference), Is.EqualTo(references.Length), "a panel each");
            Assert.That(bands.Select(b => b.Name), Is.EqualTo(new[] { references[0], references[2], references[3] }));
            // Buchner's water is at the highest gauge 0.3 √(H/g) before Lobovský's.
            int at = bands[2].X.FindIndex(x => x > 2.6);
            Assert.That((bands[2].Y[at], bands[2].Upper[at]), Is.EqualTo((0.007, 0.534)));
            Assert.That(bands.All(b => b.Y.Zip(b.Upper, (low, high) => high - low).All(width => width >= 0.0)), Is.True);
        }

        [Test]
        public void TheCasesGeometryIsTheTablesAndGaugesStandOnTheFloor()
        {
            var impact = new WallImpactCase();
            CaseSetup coarse = impact.Build(WallCaseRig.Coarse(impact, CaseMethod.Find("standard"), 10));
            float floor = -0.5f * coarse.Settings.DomainSize.y;

            Assert.That(coarse.Settings.DomainSize.x, Is.EqualTo(3.22f).Within(1e-3f));
            Assert.That(coarse.Particles.Max(p => p.Position.x) - coarse.Particles.Min(p => p.Position.x), Is.EqualTo(1.14).Within(0.02),
                "1.2 m less a spacing");
            Assert.That(coarse.Patches.Select(p => p.Centre.y - floor), Is.EqualTo(new[] { 0.03f, 0.03f, 0.06f, 0.16f }).Within(1e-5f));
            Assert.That(coarse.Patches.All(p => p.Size.y == 0.06f), Is.True, "a spacing high");
        }

        private static double At(double[][] means, int gauge, double t)
        {
            int i = (int)Math.Floor((t - ConvergedPressure.Start) / ConvergedPressure.Interval + 1e-9);
            return i < 0 ? 0.0 : means[gauge][Math.Min(i, means[gauge].Length - 1)];
        }

        private static WallImpactMetric Watched(Func<int, double, double> pressure, double until = 6.05)
        {
            var metric = new WallImpactMetric(Time, Pressure);
            metric.Read(0.0, Readings(_ => double.NaN));
            for (int i = 1; i * Interval < until; i++)
            {
                metric.Read(i * Interval * Time, Readings(gauge => Pressure * pressure(gauge, (i - 0.5) * Interval)));
            }
            return metric;
        }

        private static CaseReadings Readings(Func<int, double> pressure) =>
            new CaseReadings(Array.Empty<Vector3>(), Enumerable.Range(0, 4).Select(pressure).ToArray());
    }
}
