using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The metric on particles that are moved by hand, exactly and wrongly.</summary>
    public sealed class EllipsoidMetricTests
    {
        private const double End = 6.0;
        private static readonly EllipsoidMotion exact = new EllipsoidMotion(0.5, 8);
        private static readonly List<Vector3> ball = CaseLattice.Ball(1, 0.25);

        [TestCase(1.0, 0.05)]
        [TestCase(1.0, 0.0473)]
        [TestCase(3.5, 0.05)]
        public void TheExactMotionHasNoError(double rate, double interval)
        {
            EllipsoidMetric metric = Watched(rate, interval, exact.AlongZ);

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-4));
            Assert.That(WallCaseStates.Named(metric, "period, T/T_exact − 1"), Is.EqualTo(0).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "first maximum over the exact one"), Is.EqualTo(1).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "second maximum over the exact one"), Is.EqualTo(1).Within(1e-3));
        }

        [TestCase(0.8)]
        [TestCase(1.1)]
        public void AWrongAmplitudeIsThatError(double amplitude)
        {
            EllipsoidMetric metric = Watched(1, 0.05, t => 1 + amplitude * (exact.AlongZ(t) - 1));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(Expected(t => 1 + amplitude * (exact.AlongZ(t) - 1))).Within(0.1).Percent);
            Assert.That(WallCaseStates.Named(metric, "second maximum over the exact one"), Is.EqualTo(amplitude).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "period, T/T_exact − 1"), Is.EqualTo(0).Within(1e-3));
        }

        [TestCase(0.95)]
        [TestCase(1.03)]
        public void AWrongPeriodIsThatError(double period)
        {
            EllipsoidMetric metric = Watched(1, 0.05, t => exact.AlongZ(t / period));

            Assert.That(WallCaseStates.Named(metric, "period, T/T_exact − 1"), Is.EqualTo(period - 1).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "period, |T/T_exact − 1|"), Is.EqualTo(Math.Abs(period - 1)).Within(1e-3));
            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(Expected(t => exact.AlongZ(t / period))).Within(2e-4));
            Assert.That(WallCaseStates.Named(metric, "second maximum over the exact one"), Is.EqualTo(1).Within(1e-3));
        }

        [Test]
        public void WhereTheBallIsDoesNotMatter() =>
            Assert.That(Watched(1, 0.05, exact.AlongZ, new Vector3(0.1f, -0.2f, 0.3f)).Evaluate()[0].Value, Is.LessThan(1e-4));

        [Test]
        public void AShortRunHasNoError()
        {
            EllipsoidMetric metric = Watched(1, 0.05, exact.AlongZ, default, 4.4);

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
            Assert.That(WallCaseStates.Named(metric, "second maximum over the exact one"), Is.NaN);
        }

        [Test]
        public void AMotionThatDoesNotTurnHasNoPeriod() =>
            Assert.That(WallCaseStates.Named(Watched(1, 0.05, t => 1 + 0.1 * t), "period, T/T_exact − 1"), Is.NaN);

        [Test]
        public void CurvesAreInSecondsAndTheReferenceIsExact()
        {
            IReadOnlyList<CaseSeries> series = Watched(2, 0.05, exact.AlongZ).Series();

            Assert.That(series[0].IsReference);
            Assert.That(series[0].X.Last(), Is.EqualTo(3).Within(1e-9));
            Assert.That(series[0].Y[20], Is.EqualTo(1.38260).Within(1e-5), "t = 0.5 s is 1/ω");
            Assert.That(series[1].Y[20], Is.EqualTo(1.38260).Within(1e-4));
        }

        // Simpson's rule, other than the metric's.
        private static double Expected(Func<double, double> wrong)
        {
            const int Parts = 2000;
            double sum = 0;
            for (int i = 0; i <= Parts; i++)
            {
                double t = i * exact.Period / Parts, error = wrong(t) - exact.AlongZ(t);
                sum += error * error * (i == 0 || i == Parts ? 1 : i % 2 == 1 ? 4 : 2) / (3.0 * Parts);
            }
            return Math.Sqrt(sum) / 0.70244;
        }

        private static EllipsoidMetric Watched(double rate, double interval, Func<double, double> axis, Vector3 centre = default,
            double end = End)
        {
            var metric = new EllipsoidMetric(exact, rate);
            for (int s = 0; s * interval <= end + 1e-9; s++)
            {
                float z = (float)axis(s * interval), x = 1f / Mathf.Sqrt(z);
                metric.Sample(s * interval / rate,
                    WallCaseStates.State(ball.Count, i => centre + new Vector3(x * ball[i].x, x * ball[i].y, z * ball[i].z)));
            }
            return metric;
        }
    }
}
