using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class RestEstimateTests
    {
        // Sound crosses in 0.1 s, liquid settles for 0.8 s at most.
        private static RestEstimate Estimate(double flow = 0.0) => new RestEstimate(0.1, 0.8, flow);

        [TestCase(3.0)]
        [TestCase(8.0)]
        [TestCase(15.0)]
        public void ADecayByAConstantRateIsForeseen(double rate)
        {
            const double Start = 100.0;
            RestEstimate estimate = Estimate();
            double end = Math.Log(Start) / rate;
            double last = 0.0;
            for (double time = 0.0; time < 0.3; time += 0.01) last = estimate.Settling(time, Start * Math.Exp(-rate * time));
            double left = Math.Min(0.8, end) - 0.29;
            Assert.That(last, Is.EqualTo(left).Within(1e-6 + 0.02 * left));
        }

        [Test]
        public void BeforeAnythingIsKnownTheLongestTimeIsLeft() =>
            Assert.That(Estimate().Settling(0.0, 50.0), Is.EqualTo(0.8).Within(1e-12));

        [Test]
        public void LiquidThatDoesNotSettleWillFlow()
        {
            RestEstimate estimate = Estimate(2.0);
            double left = 0.0;
            for (double time = 0.0; time < 0.5; time += 0.01) left = estimate.Settling(time, 50.0);
            Assert.That(left, Is.EqualTo(0.8 - 0.49 + 2.0 + 0.4).Within(1e-9));
            Assert.That(estimate.Flowing(0.5), Is.EqualTo(1.5 + 0.4).Within(1e-9));
        }

        [Test]
        public void LiquidAtRestWaitsForOneCrossingOnly()
        {
            Assert.That(Estimate().Settling(0.04, 0.5), Is.EqualTo(0.06).Within(1e-12));
            Assert.That(Estimate().Settling(0.2, 0.5), Is.Zero);
        }
    }
}
