using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Least squares with coefficients that are not negative, against the conditions that hold at such a minimum.</summary>
    public sealed class NonnegativeFitTests
    {
        [Test]
        public void ExactDataGiveTheirCoefficients()
        {
            double[] truth = { 3.0, 0.25e-3, 0.0 };
            List<double[]> terms = Terms(12);

            double[] fit = NonnegativeFit.Solve(terms, terms.Select(t => NonnegativeFit.Dot(t, truth)).ToList(),
                Enumerable.Repeat(1.0, 12).ToList());

            for (int i = 0; i < 3; i++) Assert.That(fit[i], Is.EqualTo(truth[i]).Within(1e-9 * 3.0), $"coefficient {i}");
        }

        [Test]
        public void AtTheMinimumNoCoefficientCanImproveTheFit([Range(1, 20)] int seed)
        {
            var random = new Random(seed);
            List<double[]> terms = Terms(9);
            List<double> values = terms.Select(t => 1.0 - 1e-4 * t[1] + 4.0 * random.NextDouble()).ToList();
            List<double> weights = values.Select(_ => 0.5 + random.NextDouble()).ToList();
            double[] fit = NonnegativeFit.Solve(terms, values, weights);

            Assert.That(fit.All(c => c >= 0.0), Is.True);
            for (int j = 0; j < fit.Length; j++)
            {
                double scale = terms.Sum(t => t[j] * t[j]);
                double gradient = Enumerable.Range(0, terms.Count)
                    .Sum(s => weights[s] * terms[s][j] * (NonnegativeFit.Dot(terms[s], fit) - values[s])) / Math.Sqrt(scale);
                // Zero where the coefficient is free; uphill where it is held at zero.
                if (fit[j] > 0.0)
                    Assert.That(gradient, Is.EqualTo(0.0).Within(1e-6), $"coefficient {j}");
                else
                    Assert.That(gradient, Is.GreaterThan(-1e-6), $"coefficient {j}");
            }
        }

        [Test]
        public void TermsThatDependOnEachOtherAreNoHarm()
        {
            List<double[]> terms = Enumerable.Range(1, 6).Select(i => new[] { (double)i, 2.0 * i, 0.0 }).ToList();

            double[] fit = NonnegativeFit.Solve(terms, terms.Select(t => 5.0 * t[0]).ToList(), Enumerable.Repeat(1.0, 6).ToList());

            Assert.That(fit[0] + 2.0 * fit[1], Is.EqualTo(5.0).Within(1e-9));
            Assert.That(fit[2], Is.Zero);
        }

        [Test]
        public void NoSamplesAreRefused() =>
            Assert.That(() => NonnegativeFit.Solve(new double[0][], new double[0], new double[0]), Throws.ArgumentException);

        private static List<double[]> Terms(int count) =>
            Enumerable.Range(1, count).Select(i => new[] { 1.0, 500.0 * i, Math.Pow(500.0 * i, 1.5) }).ToList();
    }
}
