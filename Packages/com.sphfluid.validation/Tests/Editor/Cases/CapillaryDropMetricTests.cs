using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class CapillaryDropMetricTests
    {
        private const double Tension = 0.05, Mass = 0.004, Viscosity = 1e-5, Radius = 0.01;
        private static readonly double lamb = Math.Sqrt(32.0 * Math.PI * Tension / (3.0 * Mass)), set = 5.0 * Viscosity / (Radius * Radius);
        private static readonly List<Vector3> ball = CaseLattice.Ball(Radius, Radius / 6.0);

        [Test]
        public void LambsFrequencyIsThatOfItsUsualForm()
        {
            double density = Mass / (4.0 / 3.0 * Math.PI * Radius * Radius * Radius);
            Assert.That(CapillaryDropMetric.FrequencyOf(Tension, Mass),
                Is.EqualTo(Math.Sqrt(8.0 * Tension / (density * Radius * Radius * Radius))).Within(1e-9).Percent);
        }

        [TestCase(1.0, 1.0)]
        [TestCase(1.1, 3.0)]
        [TestCase(0.8, 0.2)]
        public void PeriodAndDampingAreFound(double frequencyRatio, double dampingRatio)
        {
            CapillaryDropMetric metric = Watched(0.02, frequencyRatio, dampingRatio);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new CapillaryDropCase().ErrorName));
            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(Math.Abs(1.0 / frequencyRatio - 1.0)).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "period, T/T_Lamb − 1"), Is.EqualTo(1.0 / frequencyRatio - 1.0).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "damping rate over the frequency"),
                Is.EqualTo(dampingRatio * set / lamb).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "damping beyond the set viscosity's over the frequency"),
                Is.EqualTo((dampingRatio - 1.0) * set / lamb).Within(1e-3));
        }

        [Test]
        public void ADropThatDoesNotSwingHasNoPeriod() => Assert.That(Watched(0.0, 1.0, 1.0).Evaluate()[0].Value, Is.NaN);

        [Test]
        public void ASwingFarFromLambsFails() => Assert.That(() => Watched(0.02, 2.7, 1.0).Evaluate(),
            Throws.TypeOf<SearchBoundException>().With.Message.StartsWith(new CapillaryDropCase().Name + ": the frequency"));

        [Test]
        public void WhereTheDropFliesDoesNotMatter()
        {
            CapillaryDropMetric metric = Watched(0.02, 1.0, 1.0, 0.05f);
            Assert.That(metric.Evaluate()[0].Value, Is.Zero.Within(1e-3));
            Assert.That(metric.Series()[1].Y, Is.EqualTo(metric.Series()[0].Y).Within(0.02));
        }

        private static CapillaryDropMetric Watched(double swing, double frequencyRatio, double dampingRatio, float speed = 0f)
        {
            var metric = new CapillaryDropMetric(Tension, Mass, Viscosity, Radius);
            double period = 2.0 * Math.PI / lamb;
            for (int i = 0; i <= 80; i++)
            {
                double t = period * i / 32.0;
                double longer = 1.0 + swing * Math.Exp(-dampingRatio * set * t) * Math.Cos(frequencyRatio * lamb * t);
                var shape = new Vector3((float)Math.Pow(longer, -0.5), (float)Math.Pow(longer, -0.5), (float)longer);
                Vector3 place = speed * (float)t * Vector3.one;
                metric.Sample(t, WallCaseStates.State(ball.Count, n => Vector3.Scale(shape, ball[n]) + place));
            }
            return metric;
        }
    }
}
