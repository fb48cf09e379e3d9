using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class HeaveTankTests
    {
        [Test]
        public void AWideBoxOverAShallowGapHasTheAddedMassOfTheFlowBelowIt()
        {
            // u = −V x/d below: ∫ ½ u² d dx gives b³/(3d) of half the box, and the flow comes out at its edge against φ = 0 nearby.
            const double Cell = 0.05;
            var tank = new HeaveTank(48, 6, 40, 4, Cell, 9.81);
            double beam = 40 * Cell, gap = 2 * Cell;
            Assert.That(tank.AddedArea, Is.InRange(beam * beam * beam / (3.0 * gap), 1.35 * beam * beam * beam / (3.0 * gap)));
        }

        [Test]
        public void ReleasedItStartsWithTheAccelerationOfItsWeightAndAddedMass()
        {
            var tank = new HeaveTank(60, 30, 12, 12, 1.0 / 30.0, 9.81);
            const double Step = 1e-3;
            IReadOnlyList<double> heave = tank.Release(0.01, 10.0 * Step, Step);
            // At first the level beside it acts too: it is low by 12/48 of the height, and pulls as a tank that is emptied by that.
            double beam = 12.0 / 30.0, acceleration = 9.81 * beam * 0.01 * (1.0 + 12.0 / 48.0) / (beam * beam + tank.AddedArea);
            Assert.That(heave[0] - heave[10], Is.EqualTo(0.5 * acceleration * 1e-4).Within(1).Percent);
        }

        [Test]
        public void FinerGridsAgree()
        {
            IReadOnlyList<double> coarse = Case(1), fine = Case(3);
            double scale = Math.Sqrt(fine.Sum(z => z * z) / fine.Count);
            double off = Math.Sqrt(fine.Zip(coarse, (a, b) => (a - b) * (a - b)).Sum() / fine.Count);
            Assert.That(off / scale, Is.LessThan(0.05), "a cell of 1/20 of the depth against 1/60");
        }

        [Test]
        public void InAClosedTankTheHeaveGoesOnForEver()
        {
            // Short: the box and one wave of the level beside it, no energy is lost.
            IReadOnlyList<double> heave = new HeaveTank(24, 20, 8, 8, 0.05, 9.81).Release(0.1, 30.0, 1.0 / 60.0);
            Assert.That(heave.Skip(1500).Max(), Is.InRange(0.085, 0.105));
            Assert.That(heave.Skip(1500).Min(), Is.InRange(-0.105, -0.085));
        }

        [Test]
        public void InALongTankTheWavesCarryTheHeaveAway()
        {
            // Another program of the same equations: trough −0.0784 at 0.9 s, crest 0.0375 at 1.8 s; in half the length 0.080.
            IReadOnlyList<double> heave = new HeaveTank(80, 20, 8, 8, 0.05, 9.81).Release(0.1, 3.0, 1.0 / 60.0);
            Assert.That(heave[54], Is.EqualTo(-0.0784).Within(2e-4));
            Assert.That(heave[108], Is.EqualTo(0.0375).Within(2e-4));
            Assert.That(Case(1)[108], Is.EqualTo(0.0804).Within(2e-4));
        }

        [Test]
        public void ABandedMatrixIsFactored([Values(1, 2, 7)] int band)
        {
            const int Count = 23;
            var random = new Random(5);
            var full = new double[Count, Count + 1];
            var banded = new BandedCholesky(Count, band);
            for (int i = 0; i < Count; i++)
                for (int j = Math.Max(0, i - band); j <= i; j++)
                {
                    double value = i == j ? 2.0 * band + 1.0 : random.NextDouble() - 0.5;
                    banded.Add(i, j, value);
                    full[i, j] = full[j, i] = value;
                }
            var x = new double[Count];
            for (int i = 0; i < Count; i++) full[i, Count] = x[i] = random.NextDouble();
            banded.Factor();
            banded.Solve(x);
            Assert.That(x, Is.EqualTo(LinearSystem.Solve(full)).Within(1e-12));
        }

        [Test]
        public void AMatrixThatIsNotDefiniteIsRefused()
        {
            var matrix = new BandedCholesky(2, 1);
            matrix.Add(0, 0, 1.0);
            matrix.Add(1, 0, 2.0);
            matrix.Add(1, 1, 1.0);
            Assert.That(() => matrix.Factor(), Throws.TypeOf<ArithmeticException>());
        }

        // The case's own tank, so many cells to a twentieth of the depth.
        private static IReadOnlyList<double> Case(int fine) =>
            new HeaveTank(40 * fine, 20 * fine, 8 * fine, 8 * fine, 0.05 / fine, 9.81).Release(0.1, 3.0, 1.0 / 60.0);
    }
}
