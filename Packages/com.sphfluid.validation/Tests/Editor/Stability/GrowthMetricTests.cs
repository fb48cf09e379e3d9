using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What diverges by the time step is distinguished from what grows by itself, on motions that are made up.</summary>
    public sealed class GrowthMetricTests
    {
        [TestCase(-1.2, false, true)]
        [TestCase(-0.99, false, false)]
        [TestCase(1.2, false, false)]
        [TestCase(-1.2, true, true)]
        [TestCase(-0.99, true, false)]
        public void TellsAlternatingGrowth(double factor, bool acrossAFace, bool fails)
        {
            var metric = new GrowthMetric(30.0, new Vector3(1f, 0f, 0f));
            for (int n = 0; n < 40 && metric.Failure == null; n++)
            {
                // Beside a motion that all share, which crosses the face at 0.5 m.
                double x = (acrossAFace ? 0.49 + 1e-3 * n : 0.1) + 1e-4 * Math.Pow(factor, n);
                metric.Sample(n, State(x - Math.Round(x), 0.3 * Math.Sin(0.05 * n)));
            }

            Assert.That(metric.Failure != null, Is.EqualTo(fails), $"growth {metric.Growth}");
        }

        [Test]
        public void MeasuresTheAmplitude()
        {
            var metric = new GrowthMetric(1e6, Vector3.zero);
            for (int n = 0; n <= 8; n++) metric.Sample(n, State(0.01 * ((n & 1) == 0 ? 1.0 : -1.0) * (n < 3 ? 1.0 : 2.0), 0.0));

            // The first three samples swing by 1, the last seven contain the change from 1 to 2 at the far end alone: (2 · 64 − 1)/64.
            Assert.That(metric.Growth, Is.EqualTo(127.0 / 64.0).Within(1e-4));
        }

        private static FluidSnapshot State(double x, double y)
        {
            FluidParticle[] particles = Enumerable.Range(0, 3)
                .Select(i => new FluidParticle(new Vector3((float)x, (float)y, 0.1f * i), Vector3.zero, (uint)i)).ToArray();
            return FluidSnapshot.FromParticles(particles, new float[3], new float[3], Matrix4x4.identity);
        }
    }
}
