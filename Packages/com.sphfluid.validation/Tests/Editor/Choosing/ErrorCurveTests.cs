using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Predicted errors and their intervals, from errors whose law is known.</summary>
    public sealed class ErrorCurveTests
    {
        private static readonly int[] resolutions = { 10, 13, 20, 30 };

        [Test]
        public void APowerLawIsPredictedBetweenItsPoints()
        {
            ErrorCurve curve = Curve(n => new[] { 4.0 / (n * n) });

            foreach (double n in new[] { 10.0, 11.0, 16.0, 24.0, 30.0 })
            {
                Assert.That(curve.At(n).Value, Is.EqualTo(4.0 / (n * n)).Within(1e-9), $"{n}");
            }
        }

        [Test]
        public void TheIntervalIsWiderBetweenPointsThanAtThem()
        {
            ErrorCurve curve = Curve(n => new[] { 0.95 / n, 1.0 / n, 1.05 / n });

            double Width(double n) => curve.At(n).High / curve.At(n).Low;
            Assert.That(Width(16.0), Is.GreaterThan(Width(13.0)));
            Assert.That(Width(16.0), Is.GreaterThan(Width(20.0)));
        }

        [Test]
        public void ACoarsePointThatErrsLessThanAFinerOneIsNotTrusted()
        {
            // Right by chance at 13, where the error changes its sign.
            double[] errors = { 0.04, 0.002, 0.016, 0.012 };
            ErrorCurve curve = Curve(n => new[] { errors[Array.IndexOf(resolutions, n)] });
            Estimate chance = curve.At(13.0);

            Assert.That(chance.Value, Is.EqualTo(0.016).Within(1e-12));
            Assert.That(chance.Contains(0.002), Is.True, "what it was is possible");
            for (int n = 10; n < 30; n++) Assert.That(curve.At(n).Value, Is.GreaterThanOrEqualTo(curve.At(n + 1).Value - 1e-12), $"{n}");
        }

        [Test]
        public void NothingIsPredictedBelowTheReferencesFloor()
        {
            ErrorCurve curve = Curve(n => new[] { 1.0 / (n * n) }, 0.003);

            Assert.That(curve.At(30.0).Value, Is.EqualTo(0.003));
            Assert.That(curve.At(30.0).Low, Is.LessThan(1.0 / 900.0));
            Assert.That(curve.At(10.0).Value, Is.EqualTo(0.01).Within(1e-12));
        }

        [Test]
        public void OnlyWhatWasMeasuredIsCovered()
        {
            ErrorCurve curve = Curve(n => new[] { 1.0 / n }, 0.0, 16.0);

            Assert.That(new[] { 9.0, 10.0, 12.0, 13.0, 14.0, 19.0, 20.0, 25.0, 30.0, 31.0 }.Select(n => curve.Covers(n)),
                Is.EqualTo(new[] { false, true, true, true, false, false, true, true, true, false }), "a run failed at 16");
        }

        [Test]
        public void AMeasuredPointItselfIsCoveredThoughAFailureLiesBesideIt()
        {
            ErrorCurve curve = Curve(n => new[] { 1.0 / n }, 0.0, 8.0);

            Assert.That(curve.Covers(10.0), Is.True);
            Assert.That(curve.Covers(9.0), Is.False);
        }

        // Laws with a floor, a sign change or neither; seeds differ by 5 or 20 %. The run to predict has a seed of its own.
        [Test]
        public void NineteenOfTwentyNewRunsLieWithinTheInterval()
        {
            int within = 0, all = 0;
            for (int trial = 0; trial < 150; trial++)
            {
                var random = new Random(trial);
                double order = 0.5 + 2.0 * random.NextDouble(), floor = 0.003 * random.NextDouble(), noise = trial % 2 == 0 ? 0.05 : 0.2;
                double Law(double n) => Math.Sqrt(floor * floor + Math.Pow(0.5 * Math.Pow(n / 10.0, -order) * 0.1, 2.0));
                double Run(double n) => Law(n) * Math.Exp(noise * CaseLattice.Normal(random));
                var curves = Enumerable.Range(0, 3).Select(_ => Curve(n => new[] { Run(n), Run(n), Run(n) })).ToList();
                CurveSpread spread = CurveSpread.Of(curves.Select(c => c.Measured).ToList(), ErrorModel.Expected);
                foreach (ErrorCurve curve in curves)
                {
                    curve.Learn(spread);
                    foreach (double n in new[] { 10.0, 11.0, 14.0, 17.0, 20.0, 24.0 })
                    {
                        within += curve.At(n).Contains(Run(n)) ? 1 : 0;
                        all++;
                    }
                }
            }
            Assert.That(within / (double)all, Is.InRange(0.92, 0.999));
        }

        [Test]
        public void CurvesThatWanderHaveWiderIntervals()
        {
            double[] zigzag = { 0.04, 0.01, 0.03, 0.005 };
            LogCurve straight = Curve(n => new[] { 1.0 / n }).Measured,
                wandering = Curve(n => new[] { zigzag[Array.IndexOf(resolutions, n)] }).Measured;

            Assert.That(CurveSpread.Of(new[] { wandering }, ErrorModel.Expected).Wander,
                Is.GreaterThan(4.0 * CurveSpread.Of(new[] { straight }, ErrorModel.Expected).Wander));
        }

        private static ErrorCurve Curve(Func<int, double[]> errors, double floor = 0.0, params double[] failed) =>
            new ErrorCurve(resolutions.Select(n => ((double)n, (IReadOnlyList<double>)errors(n))).ToList(), failed, floor);
    }
}
