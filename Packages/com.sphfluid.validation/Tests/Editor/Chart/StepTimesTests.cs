using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The time of a step and its bar, from submissions that are made up.</summary>
    public sealed class StepTimesTests
    {
        [Test]
        public void EqualStepsHaveNoSpread()
        {
            StepTimes times = StepTimes.Of(new[] { 2.0, 2.0, 8.0 }, new[] { 1, 1, 4 });

            Assert.That((times.Median, times.Low, times.High, times.Spread), Is.EqualTo((2.0, 2.0, 2.0, 0.0)));
        }

        [Test]
        public void ADisturbanceOfAPartDoesNotMoveTheTime()
        {
            double[] quiet = Enumerable.Repeat(3.0, 90).ToArray();
            double[] disturbed = quiet.Select((t, i) => i >= 20 && i < 35 ? 10.0 * t : t).ToArray();
            int[] single = Enumerable.Repeat(1, 90).ToArray();

            Assert.That(StepTimes.Of(disturbed, single).Median, Is.EqualTo(3.0).Within(1e-12));
            Assert.That(StepTimes.Of(disturbed, single).Mean, Is.GreaterThan(7.0));
        }

        [Test]
        public void ABusyHalfShowsAsSpread()
        {
            double[] times = Enumerable.Range(0, 90).Select(i => i < 45 ? 3.0 : 6.0).ToArray();

            Assert.That(StepTimes.Of(times, Enumerable.Repeat(1, 90).ToArray()).Spread, Is.GreaterThan(StepTimes.BusySpread));
        }

        [Test]
        public void StepsThatDifferInTurnAreTogetherInEveryPart()
        {
            // Every fourth step sorts and takes 5 ms, the others 1: 2 ms a step.
            double[] times = Enumerable.Range(0, 360).Select(i => i % 4 == 0 ? 5.0 : 1.0).ToArray();
            StepTimes result = StepTimes.Of(times, Enumerable.Repeat(1, 360).ToArray());

            Assert.That(result.Median, Is.EqualTo(2.0).Within(1e-12));
            Assert.That(result.Spread, Is.EqualTo(0.0).Within(1e-12));
        }

        [Test]
        public void EveryStepCountsOnce()
        {
            // 100 steps of 1 ms in submissions of any length: nothing is lost at the ends of parts.
            var random = new Random(5);
            int[] steps = Enumerable.Range(0, 37).Select(_ => random.Next(1, 9)).ToArray();
            StepTimes result = StepTimes.Of(steps.Select(s => (double)s).ToArray(), steps);

            Assert.That((result.Low, result.Median, result.High, result.Mean), Is.EqualTo((1.0, 1.0, 1.0, 1.0)));
        }

        [Test]
        public void WithoutStepsThereIsNoTime()
        {
            Assert.That(StepTimes.None.Median, Is.NaN);
            Assert.That(StepTimes.Of(new double[0], new int[0]).Median, Is.NaN);
            Assert.That(() => StepTimes.Of(new[] { 1.0 }, new int[0]), Throws.ArgumentException);
            Assert.That(StepTimes.Whole(6.0, 3).Median, Is.EqualTo(2.0));
            Assert.That(StepTimes.Whole(6.0, 0).Median, Is.NaN);
        }

        [TestCase(0.25, 1.0)]
        [TestCase(0.5, 2.0)]
        [TestCase(1.0, 4.0)]
        [TestCase(0.1, 0.4)]
        public void AQuantileIsInterpolated(double share, double value) =>
            Assert.That(StepTimes.Quantile(new[] { 0.0, 1.0, 2.0, 3.0, 4.0 }, share), Is.EqualTo(value).Within(1e-12));
    }
}
