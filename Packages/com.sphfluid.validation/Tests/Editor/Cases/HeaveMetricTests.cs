using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class HeaveMetricTests
    {
        private const double Interval = 1.0 / 60.0, Rest = -0.3, Draught = 0.4;
        private const int Count = 180;

        [Test]
        public void TheExactHeaveHasNoError()
        {
            HeaveMetric metric = Watched(t => Heave(t));

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new HeaveCase().ErrorName));
            foreach (CaseError error in metric.Evaluate()) Assert.That(error.Value, Is.Zero.Within(1e-4), error.Name);
            Assert.That(metric.Series()[1].Y, Is.EqualTo(metric.Series()[0].Y).Within(1e-5));
        }

        [Test]
        public void ADraughtThatIsLessIsNoErrorOfTheMotion()
        {
            HeaveMetric metric = Watched(t => Heave(t) + 0.02);

            Assert.That(metric.Evaluate()[0].Value, Is.Zero.Within(1e-4));
            Assert.That(WallCaseStates.Named(metric, "floats too high, over the draught"), Is.EqualTo(0.05).Within(1e-4));
            Assert.That(WallCaseStates.Named(metric, "first trough, depth over the exact one − 1"), Is.Zero.Within(1e-3));
        }

        [Test]
        public void AHeaveThatIsSlowAndWeakIsFound()
        {
            HeaveMetric metric = Watched(t => t == 0.0 ? Heave(0.0) : 0.8 * Heave(t / 1.1));

            Assert.That(WallCaseStates.Named(metric, "first trough, time over the exact one − 1"), Is.EqualTo(0.1).Within(2e-3));
            Assert.That(WallCaseStates.Named(metric, "first crest, time over the exact one − 1"), Is.EqualTo(0.1).Within(2e-3));
            double offset = WallCaseStates.Named(metric, "floats too high, over the draught") * Draught;
            Assert.That(WallCaseStates.Named(metric, "first trough, depth over the exact one − 1"),
                Is.EqualTo(-0.2 - offset / Heave(0.75)).Within(0.01));
            Assert.That(metric.Evaluate()[0].Value, Is.GreaterThan(0.2));
        }

        [Test]
        public void ABoxThatSinksIsAFailure()
        {
            HeaveMetric metric = Watched(t => 0.1 - t);
            Assert.That(metric.Failure, Does.Contain("above its place at rest"));
        }

        [Test]
        public void AHeaveWithoutTurnsHasNoTimes() =>
            Assert.That(WallCaseStates.Named(Watched(t => 0.01), "first trough, time over the exact one − 1"), Is.NaN.Or.Not.EqualTo(0.0));

        private static double Heave(double t) => 0.1 * Math.Exp(-0.4 * t) * Math.Cos(2.0 * Math.PI * t / 1.5);

        private static HeaveMetric Watched(Func<double, double> heave)
        {
            var metric = new HeaveMetric(Enumerable.Range(0, Count).Select(i => Heave(i * Interval)).ToArray(), Interval, Rest, Draught);
            for (int i = 0; i < Count; i++)
            {
                metric.Read(i * Interval, new CaseReadings(new[] { new Vector3(0.01f, (float)(Rest + heave(i * Interval)), 0f) }));
            }
            return metric;
        }
    }
}
