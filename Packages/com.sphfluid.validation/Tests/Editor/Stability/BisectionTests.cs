using System;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class BisectionTests
    {
        [TestCase(1.37, 0.01)]
        [TestCase(0.81001, 0.01)]
        [TestCase(2.0999, 0.05)]
        public void ClosesInOnTheBorder(double border, double tolerance)
        {
            Bisection search = Run(border, tolerance);

            Assert.That(search.Low, Is.LessThanOrEqualTo(border));
            Assert.That(search.High, Is.GreaterThan(border));
            Assert.That(search.High / search.Low, Is.LessThanOrEqualTo(1.0 + tolerance));
            Assert.That(search.Trials,
                Is.LessThanOrEqualTo(2 + (int)Math.Ceiling(Math.Log(Math.Log(2.1 / 0.81) / Math.Log(1.0 + tolerance), 2.0))));
        }

        [Test]
        public void SaysWhenTheBorderLiesOutside()
        {
            Bisection below = Run(0.5, 0.01), above = Run(3.0, 0.01);

            Assert.That((below.Low, below.High, below.Trials), Is.EqualTo((0.0, 0.81, 1)));
            Assert.That((above.Low, above.High, above.Trials), Is.EqualTo((2.1, double.PositiveInfinity, 2)));
        }

        [Test]
        public void RefusesWhatItCannotDivide()
        {
            Assert.That(() => new Bisection(1.0, 1.0, 0.01), Throws.ArgumentException);
            Assert.That(() => new Bisection(0.0, 1.0, 0.01), Throws.ArgumentException);
            Assert.That(() => Run(1.0, 0.1).Add(true), Throws.InvalidOperationException);
        }

        private static Bisection Run(double border, double tolerance)
        {
            var search = new Bisection(0.81, 2.1, tolerance);
            while (!search.IsDone) search.Add(search.Next <= border);
            return search;
        }
    }
}
