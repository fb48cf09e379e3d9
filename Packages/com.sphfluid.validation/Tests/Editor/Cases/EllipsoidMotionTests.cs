using System;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The exact motion against values computed with other integrators (Gauss-Legendre of order 8, DOP853).</summary>
    public sealed class EllipsoidMotionTests
    {
        private static readonly EllipsoidMotion motion = new EllipsoidMotion(0.5, 9);

        [TestCase(0.0, 1.0)]
        [TestCase(0.5, 1.24166)]
        [TestCase(1.0, 1.38260)]
        [TestCase(1.5, 1.35098)]
        [TestCase(2.0, 1.16246)]
        [TestCase(2.5, 0.91535)]
        [TestCase(3.0, 0.73738)]
        [TestCase(3.5, 0.69204)]
        [TestCase(4.0, 0.78616)]
        public void HalfAxisIsThatOfTheTable(double time, double expected) =>
            Assert.That(motion.AlongZ(time), Is.EqualTo(expected).Within(6e-6));

        [Test]
        public void PeriodAndRangeAreThoseOfTheTable()
        {
            Assert.That(motion.Period, Is.EqualTo(4.49936).Within(2e-5));
            Assert.That(motion.Least, Is.EqualTo(0.68988).Within(1e-5));
            Assert.That(motion.Greatest, Is.EqualTo(1.39232).Within(1e-5));
        }

        [Test]
        public void VolumeAndEnergyStay()
        {
            for (double t = 0; t < 9; t += 0.0371)
            {
                double x = motion.Across(t), z = motion.AlongZ(t), rateZ = motion.RateAlongZ(t), rateX = -0.5 * rateZ * x / z;
                Assert.That(x * x * z, Is.EqualTo(1).Within(1e-9));
                Assert.That(0.5 * (2 * (x * x + rateX * rateX) + z * z + rateZ * rateZ), Is.EqualTo(1.6875).Within(1e-9));
            }
        }

        [Test]
        public void RatesAreThoseOfTheHalfAxes()
        {
            const double Step = 1e-4;
            for (double t = 0.01; t < 8; t += 0.77)
            {
                Assert.That(motion.RateAlongZ(t),
                    Is.EqualTo((motion.AlongZ(t + Step) - motion.AlongZ(t - Step)) / (2 * Step)).Within(1e-7));
            }
        }

        [Test]
        public void SmallSwingsHaveTheSmallSwingsPeriod()
        {
            Assert.That(new EllipsoidMotion(1e-3, 7).Period, Is.EqualTo(2 * Math.PI / Math.Sqrt(2)).Within(1e-4));
            Assert.That(motion.CentrePressure(0), Is.EqualTo(0.5 * (3 + 0.375) / 3).Within(1e-9), "λ = (3 + σ² 3/2)/3");
        }

        [Test]
        public void TimesOutsideAreErrors()
        {
            Assert.That(() => motion.AlongZ(-0.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => motion.AlongZ(9.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }
}
