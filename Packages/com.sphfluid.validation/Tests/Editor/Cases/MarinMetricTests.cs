using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class MarinMetricTests
    {
        private const double Spacing = 0.001; // the record's digits are whole layers
        private static readonly Vector3 tank = new Vector3(3.22f, 1f, 1f);

        [Test]
        public void TheRecordHasNoError()
        {
            MarinMetric metric = Watched((gauge, row) => MarinHeights.Heights[gauge][row]);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new MarinCase().ErrorName));
            Assert.That(metric.Evaluate().Count, Is.EqualTo(6));
            foreach (CaseError error in metric.Evaluate()) Assert.That(error.Value, Is.Zero.Within(1e-3), error.Name);
        }

        [Test]
        public void PressuresOnTheBoxAreHeldAgainstTheRecords()
        {
            MarinMetric metric = Watched((gauge, row) => MarinHeights.Heights[gauge][row]);
            metric.Read(0.0, new CaseReadings(Array.Empty<Vector3>(), new[] { double.NaN, double.NaN }));
            for (int i = 0; i < MarinPressures.Front.Length; i++)
            {
                metric.Read((i + 1) * MarinPressures.Interval,
                    new CaseReadings(Array.Empty<Vector3>(), new[] { MarinPressures.Front[i], 1.2 * MarinPressures.Top[i] }));
            }

            Assert.That(metric.Evaluate().Count, Is.EqualTo(10));
            Assert.That(WallCaseStates.Named(metric, "pressure on the front of the box, normalised RMS"), Is.Zero.Within(1e-12));
            Assert.That(WallCaseStates.Named(metric, "impulse on the front of the box over the record's − 1"), Is.Zero.Within(1e-12));
            Assert.That(WallCaseStates.Named(metric, "pressure on the top of the box, normalised RMS"), Is.EqualTo(0.2).Within(1e-9));
            Assert.That(WallCaseStates.Named(metric, "impulse on the top of the box over the record's − 1"), Is.EqualTo(0.2).Within(1e-9));
        }

        [Test]
        public void TheRecordsOfPressureHaveTheHitAndTheLevel()
        {
            Assert.That(MarinPressures.Front, Has.Length.EqualTo(120).And.Length.EqualTo(MarinPressures.Top.Length));
            Assert.That(Array.FindIndex(MarinPressures.Front, p => p > 1000.0) * MarinPressures.Interval, Is.EqualTo(0.4).Within(1e-9),
                "P1 rises at 0.41 s");
            // ρ g (level − middle of the box) at the end, the level that of the gauges beside it.
            double level = 0.5 * (MarinHeights.Heights[0][120] + MarinHeights.Heights[1][120]);
            Assert.That(MarinPressures.Front[119], Is.EqualTo(1000.0 * 9.81 * (level - 0.0805)).Within(25).Percent);
        }

        [Test]
        public void EachGaugeIsHeldAgainstItsOwnRecord([Values(0, 1, 2, 3)] int wrong)
        {
            MarinMetric metric = Watched((gauge, row) => (gauge == wrong ? 1.1 : 1.0) * MarinHeights.Heights[gauge][row]);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.025).Within(1e-3));
            for (int gauge = 0; gauge < 4; gauge++)
            {
                Assert.That(metric.Evaluate()[1 + gauge].Value, Is.EqualTo(gauge == wrong ? 0.1 : 0.0).Within(1e-3));
            }
        }

        [Test]
        public void NoWaterErrsByOne()
        {
            MarinMetric metric = Watched((gauge, row) => 0.0);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(1.0).Within(1e-12));
        }

        [Test]
        public void WaterThatStandsAtItsFinalLevelErrsByWhatTheCautionSays()
        {
            MarinMetric metric = Watched((gauge, row) => 0.211);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.40).Within(0.005));
            Assert.That(new MarinCase().Caution, Does.Contain("0.40"));
            Assert.That(WallCaseStates.Named(metric, "returning wave, height − 1"), Is.EqualTo(0.211 / 0.398 - 1.0).Within(1e-3));
        }

        [Test]
        public void SprayAndWaterBesideTheGaugeDoNotCount()
        {
            var metric = new MarinMetric(Settings(0.05));
            List<Vector3> positions = ImpactCaseStates.Columns(tank, new[] { 0.1, 0.0, 0.25, 0.5 }, 0.05);
            positions.Add(At(0.496, 0.25, 0.0));
            positions.Add(At(0.496, 0.25, 0.02));
            positions.Add(At(0.992, 0.2, 0.0));
            positions.Add(At(1.488 + 0.101, 0.025, 0.0));
            positions.Add(At(1.488, 0.025, 0.101));

            metric.Sample(0.0, ImpactCaseStates.State(positions));

            IReadOnlyList<CaseSeries> series = metric.Series();
            Assert.That(new[] { series[1].Y[0], series[3].Y[0], series[5].Y[0], series[7].Y[0] },
                Is.EqualTo(new[] { 0.1, 0.0, 0.25, 0.5 }).Within(1e-6));
        }

        [Test]
        public void HowTheLatticeLiesToAGaugeDoesNotMatter([Values(0.0, 0.3, 0.5, 0.99)] double moved)
        {
            var positions = new List<Vector3>();
            for (int y = 0; y < 4; y++)
                for (int z = -4; z <= 4; z++)
                    for (int x = -4; x <= 4; x++) positions.Add(At(1.488 + (x + moved) * 0.05, (y + 0.5) * 0.05, (z + 0.4 * moved) * 0.05));
            var metric = new MarinMetric(Settings(0.05));

            metric.Sample(0.0, ImpactCaseStates.State(positions));

            Assert.That(metric.Series()[5].Y[0], Is.EqualTo(0.2).Within(1e-5));
        }

        [Test]
        public void ARunThatEndsEarlyHasNoError()
        {
            var metric = new MarinMetric(Settings(Spacing));
            metric.Sample(0.0, ImpactCaseStates.State(new List<Vector3>()));
            metric.Sample(5.9, ImpactCaseStates.State(new List<Vector3>()));

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        // Kleefsman's record by gauges: 2 cm is passed in the order of the distance from the water; the means over 20 ms of another
        // reduction.
        [Test]
        public void TheTableHasItsColumnsByPlace()
        {
            Assert.That(MarinHeights.Rows, Is.EqualTo(121));
            Assert.That(Array.ConvertAll(MarinHeights.Heights, column => column.Length), Is.All.EqualTo(121));
            Assert.That(Passed(2) * MarinHeights.Interval, Is.EqualTo(0.218).Within(0.05));
            Assert.That(Passed(1) * MarinHeights.Interval, Is.EqualTo(0.368).Within(0.05));
            Assert.That(Passed(0) * MarinHeights.Interval, Is.EqualTo(0.920).Within(0.05));
            double[] times = { 0.5, 1, 1.5, 2, 2.5, 4.5 };
            double[] deep = { 0.427, 0.279, 0.182, 0.130, 0.104, 0.260 }, before = { 0.099, 0.179, 0.238, 0.286, 0.281, 0.145 };
            for (int i = 0; i < times.Length; i++)
            {
                int row = (int)Math.Round(times[i] / MarinHeights.Interval);
                Assert.That(MarinHeights.Heights[3][row], Is.EqualTo(deep[i]).Within(0.006));
                Assert.That(MarinHeights.Heights[1][row], Is.EqualTo(before[i]).Within(0.006));
            }
        }

        private static int Passed(int gauge) => Array.FindIndex(MarinHeights.Heights[gauge], height => height > 0.02);

        private static MarinMetric Watched(Func<int, int, double> height)
        {
            var metric = new MarinMetric(Settings(Spacing));
            for (int row = 0; row < MarinHeights.Rows; row++)
            {
                var heights = new double[MarinHeights.Gauges.Length];
                for (int gauge = 0; gauge < heights.Length; gauge++) heights[gauge] = height(gauge, row);
                metric.Sample(row * MarinHeights.Interval, ImpactCaseStates.State(ImpactCaseStates.Columns(tank, heights, Spacing)));
            }
            return metric;
        }

        private static Vector3 At(double x, double y, double z) => new Vector3((float)x, (float)y, (float)z) -
            new Vector3(0.5f * tank.x, 0.5f * tank.y, 0f);

        private static FluidSolverSettings Settings(double spacing) =>
            new FluidSolverSettings { DomainSize = tank, Spacing = (float)spacing };
    }
}
