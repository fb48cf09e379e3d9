using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class ChannelMetricTests
    {
        private const double Gap = 0.8, MaxSpeed = 0.1;
        private static readonly double[] Times = { 2, 10, 20, 100 };

        [Test]
        public void AnExactFlowHasNoError()
        {
            ChannelMetric metric = Watched((y, t) => new Vector3((float)Exact(y, t), 0, 0));

            foreach (CaseError error in metric.Evaluate()) Assert.That(error.Value, Is.LessThan(1e-6), error.Name);
            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo("profile, largest L2/u_max"));
            Assert.That(metric.Series().Count, Is.EqualTo(8));
        }

        [Test]
        public void AFlowThatErrsByAFactorErrsByIt()
        {
            // RMS of the parabola 4 s (1 − s) over the layers' middles, times 7 %.
            ChannelMetric metric = Watched((y, t) => new Vector3((float)(1.07 * Exact(y, t)), 0, 0));
            double squares = 0;
            for (int j = 0; j < 10; j++) squares += Math.Pow(4 * (j + 0.5) / 10 * (1 - (j + 0.5) / 10), 2) / 10;

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.07 * Math.Sqrt(squares)).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "profile, L2/u_max at t = 2 s"),
                Is.EqualTo(0.07 * 0.0195 * Math.Sqrt(squares)).Within(1e-6), "the sample at 1.95 s");
            Assert.That(WallCaseStates.Named(metric, "profile at the end, relative L2"), Is.EqualTo(0.07).Within(1e-5));
        }

        [Test]
        public void LiquidThatStaysAtRestIsWrongByAllOfTheFlow()
        {
            ChannelMetric metric = Watched((y, t) => Vector3.zero);

            Assert.That(WallCaseStates.Named(metric, "profile at the end, relative L2"), Is.EqualTo(1).Within(1e-6));
        }

        [Test]
        public void FlowAcrossTheChannelIsReported()
        {
            ChannelMetric metric = Watched((y, t) => new Vector3((float)Exact(y, t), 0.003f, 0.004f));

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-6));
            Assert.That(WallCaseStates.Named(metric, "flow across the channel, RMS/u_max"), Is.EqualTo(0.05).Within(1e-6));
        }

        [Test]
        public void ARunThatEndsEarlyHasNoMainError()
        {
            ChannelMetric metric = Metric();
            metric.Sample(2, Layers((y) => Vector3.zero));

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
            Assert.That(metric.Evaluate()[1].Value, Is.Not.NaN);
            Assert.That(metric.Evaluate()[2].Value, Is.NaN);
        }

        // A parabola that grows in 100 s.
        private static double Exact(double y, double t) => MaxSpeed * t / 100 * 4 * y / Gap * (1 - y / Gap);

        private static ChannelMetric Metric() => new ChannelMetric(Gap, MaxSpeed, Exact, Times, 2, 10);

        // Samples a step early, as steps that do not divide the interval give.
        private static ChannelMetric Watched(Func<double, double, Vector3> velocity)
        {
            ChannelMetric metric = Metric();
            for (int s = 0; s <= 50; s++)
            {
                double t = s == 50 ? 100 : Math.Max(0, 2 * s - 0.05 * (s % 5));
                metric.Sample(t, Layers(y => velocity(y, t)));
            }
            return metric;
        }

        private static FluidSnapshot Layers(Func<double, Vector3> velocity)
        {
            double Height(int i) => (i % 10 + 0.5) / 10 * Gap;
            return WallCaseStates.State(70, i => new Vector3(0.1f * (i / 10), (float)(Height(i) - 0.5 * Gap), 0), i => velocity(Height(i)));
        }
    }
}
