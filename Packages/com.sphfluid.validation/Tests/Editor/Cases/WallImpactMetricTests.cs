using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class WallImpactMetricTests
    {
        private const double Time = 0.25, Pressure = 6000.0, Interval = 0.01;

        [Test]
        public void TheRecordHasNoError()
        {
            WallImpactMetric metric = Watched(At);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new WallImpactCase().ErrorName));
            foreach (CaseError error in metric.Evaluate())
            {
                Assert.That(error.Value,
                    Is.Zero.Within(error.Name.StartsWith("shift") ? 2e-3 : error.Name.StartsWith("highest") ? 5e-3 : 1e-3), error.Name);
            }
        }

        [Test]
        public void AShiftIsFoundAndTakenOut()
        {
            WallImpactMetric metric = Watched(t => At(t + 0.2));

            Assert.That(metric.Evaluate()[0].Value, Is.Zero.Within(2e-3));
            Assert.That(metric.Evaluate()[1].Value, Is.GreaterThan(0.1));
            Assert.That(WallCaseStates.Named(metric, "shift in time over √(H/g)"), Is.EqualTo(0.2).Within(2e-3), "the record is later");
            Assert.That(WallCaseStates.Named(metric, "even pressure over the record's − 1"), Is.Zero.Within(2e-3));
        }

        [Test]
        public void APressureThatIsTooHighIsFound()
        {
            WallImpactMetric metric = Watched(t => 1.25 * At(t));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.25).Within(0.01), "a shift of the rise takes some of it away");
            Assert.That(metric.Evaluate()[1].Value, Is.EqualTo(0.25).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "even pressure over the record's − 1"), Is.EqualTo(0.25).Within(5e-3));
            Assert.That(WallCaseStates.Named(metric, "highest pressure over the record's − 1"), Is.EqualTo(0.25).Within(0.01));
        }

        [Test]
        public void ARunThatEndsEarlyHasNoError()
        {
            var metric = new WallImpactMetric(Time, Pressure);
            metric.Read(0.0, Readings(double.NaN));
            metric.Read(0.3, Readings(0.0));
            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        // The record between its points, none before them, its last value after.
        private static double At(double t)
        {
            double[] times = BuchnerPressure.Times, values = BuchnerPressure.Pressures;
            if (t <= times[0]) return values[0];
            int above = Array.FindIndex(times, x => x >= t);
            if (above < 0) return values[values.Length - 1];
            double part = (t - times[above - 1]) / (times[above] - times[above - 1]);
            return values[above - 1] + part * (values[above] - values[above - 1]);
        }

        private static WallImpactMetric Watched(Func<double, double> pressure)
        {
            var metric = new WallImpactMetric(Time, Pressure);
            metric.Read(0.0, Readings(double.NaN));
            for (int i = 1; i * Interval < 6.0; i++) metric.Read(i * Interval * Time, Readings(Pressure * pressure((i - 0.5) * Interval)));
            return metric;
        }

        private static CaseReadings Readings(double pressure) => new CaseReadings(Array.Empty<Vector3>(), new[] { pressure });
    }
}
