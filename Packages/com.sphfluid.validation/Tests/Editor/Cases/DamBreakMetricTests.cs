using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class DamBreakMetricTests
    {
        private const double Width = 0.2, Gravity = 9.81, Spacing = 0.01;
        private const int SlabRows = 6;

        [Test]
        public void TheExperimentHasNoErrorAndItsShiftIsFound([Values(0.0, 0.17, -0.3)] double ahead)
        {
            DamBreakMetric metric = Watched(t => Front(t + ahead), Height, null);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new DamBreakCase().ErrorName));
            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-3));
            Assert.That(WallCaseStates.Named(metric, "front, shift in T"), Is.EqualTo(-ahead).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "front, slope dZ/dT − 1"), Is.Zero.Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.LessThan(1e-3));
            double raw = 0.0;
            for (int i = 1; i < 15; i++) raw += Math.Pow(Front(MartinMoyce.FrontTimes[i] + ahead) / MartinMoyce.Fronts[i] - 1.0, 2) / 14.0;
            Assert.That(WallCaseStates.Named(metric, new DamBreakCase().CompanionErrorName), Is.EqualTo(Math.Sqrt(raw)).Within(1e-3));
        }

        [Test]
        public void AFrontThatIsTooFarErrsByHowMuch()
        {
            DamBreakMetric metric = Watched(t => 1.05 * Front(t), t => Height(t) - 0.03, null);

            Assert.That(WallCaseStates.Named(metric, "front, raw RMS"), Is.EqualTo(0.05).Within(1e-4));
            Assert.That(metric.Evaluate()[0].Value, Is.InRange(1e-3, 0.049));
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.EqualTo(0.03).Within(3e-4));
        }

        [TestCase(0.5)]
        [TestCase(-0.6)]
        public void AFrontThatIsFartherAheadOrBehindThanIsSoughtFails(double ahead)
        {
            DamBreakMetric metric = Watched(t => Front(t + ahead), Height, null);

            Assert.That(() => metric.Evaluate(),
                Throws.TypeOf<SearchBoundException>().With.Message.StartsWith(new DamBreakCase().Name + ": the front's shift"));
            Assert.That(metric.Series(), Has.Count.EqualTo(4), "without the shifted front");
        }

        [Test]
        public void TheSlopeDoesNotDependOnTheShift()
        {
            DamBreakMetric metric = Watched(t => 0.3 + 1.2 * t, Height, null);

            double sumX = 0, sumY = 0, sumXx = 0, sumXy = 0;
            for (int i = 3; i < 15; i++)
            {
                sumX += MartinMoyce.FrontTimes[i];
                sumY += MartinMoyce.Fronts[i];
                sumXx += MartinMoyce.FrontTimes[i] * MartinMoyce.FrontTimes[i];
                sumXy += MartinMoyce.FrontTimes[i] * MartinMoyce.Fronts[i];
            }
            double slope = (12 * sumXy - sumX * sumY) / (12 * sumXx - sumX * sumX);
            Assert.That(WallCaseStates.Named(metric, "front, slope dZ/dT − 1"), Is.EqualTo(1.2 / slope - 1.0).Within(1e-4));
        }

        [Test]
        public void SprayDoesNotMoveTheFront()
        {
            DamBreakMetric metric = Watched(Front, Height, (positions, front, height) =>
            {
                for (int i = 1; i < SlabRows; i++) positions.Add(new Vector3((float)(front + 0.03), 0.005f, 0f));
                positions.Add(new Vector3((float)(front + 0.1), 0.005f, 0f));
                positions.Add(new Vector3((float)(front + 0.005), 0.035f, 0f));
                positions.Add(new Vector3(0.005f, (float)(height + 0.04), 0f));
            });

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-3));
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.LessThan(1e-3));
        }

        [Test]
        public void AFilmOnTheWallIsDistinguishedFromTheHeightBesideIt()
        {
            const double film = 0.12;
            DamBreakMetric metric = Watched(Front, Height, (positions, front, height) =>
            {
                for (double y = height + 0.5 * Spacing; y < height + film * 2.0 * Width; y += 0.5 * Spacing)
                    for (int z = 0; z < SlabRows; z++) positions.Add(new Vector3(0.005f, (float)y, (float)(z * Spacing)));
            });

            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.EqualTo(film).Within(Spacing / (2.0 * Width)));
            Assert.That(WallCaseStates.Named(metric, "height beside the wall's film, largest error"), Is.LessThan(1e-3));
        }

        [Test]
        public void ARunThatEndsEarlyHasNoError()
        {
            DamBreakMetric metric = Watched(Front, Height, null, 2.0);

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.NaN);
            Assert.That(metric.Series().Count, Is.EqualTo(4));
        }

        [Test]
        public void CurvesShowTheRawAndTheShiftedFront()
        {
            IReadOnlyList<CaseSeries> series = Watched(t => Front(t + 0.2), Height, null).Series();

            Assert.That(series[3].Name, Is.EqualTo("Z, shifted by +0.20"));
            for (int i = 0; i < series[2].X.Count; i++)
            {
                Assert.That(series[3].X[i], Is.EqualTo(series[2].X[i] + 0.2).Within(1e-3));
                Assert.That(series[3].Y[i], Is.EqualTo(series[2].Y[i]));
            }
            Assert.That(series[0].IsReference && series[1].IsReference && !series[4].IsReference);
        }

        private static DamBreakMetric Watched(Func<double, double> front, Func<double, double> height,
            Action<List<Vector3>, double, double> spray, double until = 3.9)
        {
            var settings = new FluidSolverSettings
            {
                DomainSize = new Vector3(1.5f, 0.6f, (float)(SlabRows * Spacing)),
                Spacing = (float)Spacing,
                Gravity = new Vector3(0f, -(float)Gravity, 0f),
            };
            var metric = new DamBreakMetric(settings, Width, SlabRows);
            // The table's times have two digits: its corners are met.
            for (int k = 0; k < 100 * until; k++)
            {
                double t = k / 100.0;
                double x = front(t) * Width, y = height(t / Math.Sqrt(2.0)) * 2.0 * Width;
                List<Vector3> positions = ImpactCaseStates.Fallen(settings.DomainSize, x, y, Spacing, SlabRows);
                if (spray != null)
                {
                    var flying = new List<Vector3>();
                    spray(flying, x, y);
                    foreach (Vector3 p in flying) positions.Add(p - 0.5f * settings.DomainSize);
                }
                metric.Sample(t * Math.Sqrt(Width / (2.0 * Gravity)), ImpactCaseStates.State(positions));
            }
            return metric;
        }

        private static double Front(double t) => Through(t, 1.0, MartinMoyce.FrontTimes, MartinMoyce.Fronts);

        private static double Height(double t) => Through(t, 1.0, MartinMoyce.HeightTimes, MartinMoyce.Heights);

        // Straight lines from (0, start) through the points and on beyond the last; constant before.
        private static double Through(double t, double start, double[] xs, double[] ys)
        {
            if (t <= 0.0) return start;
            int i = 0;
            while (i < xs.Length - 1 && xs[i] < t) i++;
            double x0 = i == 0 ? 0.0 : xs[i - 1], y0 = i == 0 ? start : ys[i - 1];
            return y0 + (t - x0) * (ys[i] - y0) / (xs[i] - x0);
        }
    }
}
