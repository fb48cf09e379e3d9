using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The fitted time of a step, from times whose law is known.</summary>
    public sealed class StepCostModelTests
    {
        // ms: a step, a particle, a particle's κ³, an exchange of the sort.
        private const double Fixed = 0.8, Particle = 0.6e-3, Neighbour = 0.09e-3, Exchange = 4e-6;

        private static readonly int[] counts = { 500, 1000, 1100, 2000, 4000, 4200, 8000, 16000, 32000 };
        private static readonly double[] ratios = { 2.0, 2.25, 2.5 };

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Thesis)]
        public void ExactTimesGiveTheirLaw(FluidMethodKind method)
        {
            StepCostModel model = StepCostModel.Fit(method, Samples(method, _ => 1.0));

            Assert.That(model.Coefficients[0], Is.EqualTo(Fixed).Within(1e-6));
            Assert.That(model.Coefficients[1], Is.EqualTo(Particle).Within(1e-8));
            Assert.That(model.Coefficients[2], Is.EqualTo(Neighbour).Within(1e-9));
            Assert.That(model.Coefficients[3], Is.EqualTo(method == FluidMethodKind.Thesis ? Exchange : 0.0).Within(1e-10));
            Assert.That(model.At(123456, 2.25), Is.EqualTo(Time(method, 123456, 2.25)).Within(1e-6 * Time(method, 123456, 2.25)));
            Assert.That((model.LeastParticles, model.MostParticles), Is.EqualTo((500, 32000)));
        }

        [Test]
        public void TheSortIsPaddedToAPowerOfTwo()
        {
            StepCostModel model = StepCostModel.Fit(FluidMethodKind.Thesis, Samples(FluidMethodKind.Thesis, _ => 1.0));

            // 4096 = 2¹², 78 exchanges of each; one more particle has twice as many, and 91 of each.
            Assert.That(model.At(4097, 2.0) - model.At(4096, 2.0),
                Is.EqualTo(Exchange * (8192 * 91 - 4096 * 78) + Particle + 8.0 * Neighbour).Within(1e-6));
        }

        [Test]
        public void NoisyTimesGiveTheTimeWithinTheNoise()
        {
            for (int seed = 1; seed <= 20; seed++)
            {
                var random = new Random(seed);
                StepCostModel model = StepCostModel.Fit(FluidMethodKind.Standard,
                    Samples(FluidMethodKind.Standard, _ => Math.Exp(0.05 * CaseLattice.Normal(random))));

                foreach (int count in new[] { 700, 6000, 64000 })
                {
                    Assert.That(model.At(count, 2.25) / Time(FluidMethodKind.Standard, count, 2.25), Is.EqualTo(1.0).Within(0.1),
                        $"{seed}, {count}");
                }
                Assert.That(model.Deviation, Is.EqualTo(0.05).Within(0.035), $"{seed}");
            }
        }

        [Test]
        public void TimesOfABusyMachineMoveItLittle()
        {
            var random = new Random(3);
            // Every sixth time is three times too long.
            StepCostModel model = StepCostModel.Fit(FluidMethodKind.Standard,
                Samples(FluidMethodKind.Standard, i => (i % 6 == 4 ? 3.0 : 1.0) * Math.Exp(0.03 * CaseLattice.Normal(random))));

            foreach (int count in new[] { 700, 6000, 32000 })
            {
                Assert.That(model.At(count, 2.25) / Time(FluidMethodKind.Standard, count, 2.25), Is.EqualTo(1.0).Within(0.15), $"{count}");
            }
        }

        [Test]
        public void TheStandardErrorOfTheFixedCostCoversIt()
        {
            int within = 0;
            const int Repeats = 60;
            for (int seed = 1; seed <= Repeats; seed++)
            {
                var random = new Random(100 + seed);
                StepCostModel model = StepCostModel.Fit(FluidMethodKind.Standard,
                    Samples(FluidMethodKind.Standard, _ => Math.Exp(0.05 * CaseLattice.Normal(random))));
                within += Math.Abs(model.Coefficients[0] - Fixed) <= 2.0 * model.Errors[0] ? 1 : 0;
            }
            Assert.That(within / (double)Repeats, Is.InRange(0.85, 1.0));
        }

        [Test]
        public void NoTimesAreRefused() =>
            Assert.That(() => StepCostModel.Fit(FluidMethodKind.Standard, new (int, double, double)[0]), Throws.ArgumentException);

        private static List<(int, double, double)> Samples(FluidMethodKind method, Func<int, double> factor) =>
            (from ratio in ratios from count in counts
             select (count, ratio)).Select((s, i) => (s.count, s.ratio, Time(method, s.count, s.ratio) * factor(i))).ToList();

        private static double Time(FluidMethodKind method, int count, double ratio)
        {
            int levels = 0;
            while (1 << levels < count) levels++;
            double sort = method == FluidMethodKind.Thesis ? Exchange * (1 << levels) * levels * (levels + 1) / 2.0 : 0.0;
            return Fixed + count * (Particle + Neighbour * Math.Pow(ratio, 3.0)) + sort;
        }
    }
}
