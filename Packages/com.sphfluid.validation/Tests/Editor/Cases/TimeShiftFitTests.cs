using System;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class TimeShiftFitTests
    {
        private static readonly double[] xs = { 1.0, 1.7, 2.2, 3.1 };
        private static readonly SearchRange range = new SearchRange("a-case", "the shift", -0.5, 0.5, "");

        [Test]
        public void AShiftIsFound([Values(-0.49, -0.2345, 0.0, 0.11, 0.49)] double shift)
        {
            var curve = new SampledCurve();
            for (double x = 0.0; x < 4.0; x += 0.001) curve.Add(x, Square(x - shift));

            double found = TimeShiftFit.Best(curve, xs, Array.ConvertAll(xs, Square), 0, range);

            Assert.That(found, Is.EqualTo(shift).Within(1e-4));
            Assert.That(TimeShiftFit.RelativeRms(curve, xs, Array.ConvertAll(xs, Square), 0, found), Is.LessThan(1e-4));
        }

        [Test]
        public void TheLeastOfSeveralMinimaIsFound()
        {
            // Two dips: the one that fits exactly is the farther from zero.
            var curve = new SampledCurve();
            foreach ((double x, double y) in new[] { (0.0, 9.0), (0.6, 1.0), (0.8, 5.0), (1.1, 1.5), (1.3, 9.0), (2.0, 9.0) })
            {
                curve.Add(x, y);
            }

            Assert.That(TimeShiftFit.Best(curve, new[] { 1.0 }, new[] { 1.0 }, 0, range), Is.EqualTo(-0.4).Within(1e-4));
        }

        [Test]
        public void AFactorStaysAnErrorAndEarlyPointsAreLeftOut()
        {
            var curve = new SampledCurve();
            curve.Add(0.0, 1.1);
            curve.Add(4.0, 1.1);
            double[] ones = { 7.0, 1.0, 1.0, 1.0 };

            Assert.That(TimeShiftFit.RelativeRms(curve, xs, ones, 1, 0.3), Is.EqualTo(0.1).Within(1e-12));
        }

        [Test]
        public void ACurveThatIsTooShortHasNoError()
        {
            var curve = new SampledCurve();
            curve.Add(0.0, 1.0);
            curve.Add(2.0, 1.0);

            Assert.That(TimeShiftFit.RelativeRms(curve, xs, xs, 0, 0.0), Is.NaN);
            Assert.That(TimeShiftFit.Best(curve, xs, xs, 0, range), Is.NaN);
            Assert.That(new SampledCurve().At(0.0), Is.NaN);
        }

        private static double Square(double x) => 1.0 + x * x;
    }
}
