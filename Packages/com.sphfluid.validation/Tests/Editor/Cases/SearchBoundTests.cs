using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>A fit whose best value lies at or beyond the bound of its search fails, and says which.</summary>
    public sealed class SearchBoundTests
    {
        private static readonly SearchRange range = new SearchRange("a-case", "the shift", -0.5, 0.5, "Look at the curve.");

        [TestCase(-0.5)]
        [TestCase(0.4999)]
        [TestCase(0.5)]
        [TestCase(7.0)]
        public void CaseQuantityBoundAndCureAreNamed(double value)
        {
            Assert.That(() => range.Require(value), Throws.TypeOf<SearchBoundException>().With.Message.StartsWith("a-case: the shift")
                .And.Message.Contains(value < 0.0 ? "bound -0.5" : "bound 0.5").And.Message.EndsWith("Look at the curve."));
        }

        [TestCase(-0.49)]
        [TestCase(0.0)]
        [TestCase(double.NaN)]
        public void WhatLiesWithinIsAResult(double value) => Assert.That(range.Require(value), Is.EqualTo(value));

        [TestCase(0.5)]
        [TestCase(-0.6)]
        [TestCase(0.7)]
        [TestCase(-2.0)]
        public void AShiftAtOrBeyondTheBoundFails(double shift)
        {
            double[] xs = { 3.0, 3.7, 4.2, 5.1 };
            var curve = new SampledCurve();
            for (double x = 0.0; x < 9.0; x += 0.001) curve.Add(x, Square(x - shift));

            Assert.That(() => TimeShiftFit.Best(curve, xs, Array.ConvertAll(xs, Square), 0, range), Throws.TypeOf<SearchBoundException>());
            Assert.That(TimeShiftFit.TryBest(curve, xs, Array.ConvertAll(xs, Square), 0, range, out _), Is.False);
        }

        // The misfit falls all the way beyond the bound with a dip every 0.05: the last dip before the bound is no result.
        [Test]
        public void ARippleDoesNotHideTheBound()
        {
            double[] xs = { 3.0, 3.7, 4.2, 5.1 };
            var curve = new SampledCurve();
            for (double x = 0.0; x < 9.0; x += 0.001) curve.Add(x, Square(x - 0.53) + 0.4 * Math.Sin(2.0 * Math.PI * x / 0.05));

            Assert.That(() => TimeShiftFit.Best(curve, xs, Array.ConvertAll(xs, Square), 0, range),
                Throws.TypeOf<SearchBoundException>().With.Message.Contains("bound 0.5"));
        }

        [TestCase(2.5, 0.0, "frequency")]
        [TestCase(3.0, 0.1, "frequency")]
        [TestCase(9.0, 0.0, "frequency")]
        [TestCase(0.2, 0.0, "frequency")]
        [TestCase(1.0, 1.2, "damping rate")]
        [TestCase(1.0, -0.3, "damping rate")]
        public void ASwingAtOrBeyondTheBoundFails(double frequency, double rate, string quantity)
        {
            var times = new List<double>();
            var values = new List<double>();
            for (double t = 0; t < 13; t += 0.17)
            {
                times.Add(t);
                values.Add(Math.Exp(-rate * t) * Math.Cos(frequency * t + 0.4));
            }

            Assert.That(() => DampedOscillationFit.Of(times, values, 1.0, "a-case", "the drop"),
                Throws.TypeOf<SearchBoundException>().With.Message.StartsWith($"a-case: the {quantity} of the drop"));
        }

        [Test]
        public void ARunWhoseFitEndsAtItsBoundHasFailedAndKeepsItsCurves()
        {
            var result = new CaseResult();
            result.Take(new AtItsBound());

            Assert.That(result.Failure, Does.StartWith("a-case: the shift is sought from -0.5 to 0.5"));
            Assert.That(result.Errors, Is.Empty);
            Assert.That(result.Series.Count, Is.EqualTo(1));
        }

        private static double Square(double x) => 1.0 + x * x;

        private sealed class AtItsBound : CaseMetric
        {
            public override void Sample(double time, FluidSnapshot state)
            {
            }

            public override IReadOnlyList<CaseError> Evaluate() => new[] { new CaseError("shift", range.Require(0.5)) };

            public override IReadOnlyList<CaseSeries> Series() => new[] { new CaseSeries("front") };
        }
    }
}
