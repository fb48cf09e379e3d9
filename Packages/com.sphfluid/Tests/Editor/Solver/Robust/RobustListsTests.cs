using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class RobustListsTests
    {
        private static readonly FluidSolverSettings Settings = RobustStateRig.Robust(Vector3.one, 0.05f);

        [TestCase(0.0, double.PositiveInfinity)]
        [TestCase(0.1, 6.0)]  // two at R/10 a step close a fifth
        [TestCase(0.31, 1.0)]
        [TestCase(0.61, 0.0)]
        public void TheyServeUntilTwoBodiesMayHaveClosed(double radiiAStep, double expected)
        {
            const double step = 1.0 / 240.0;
            double speed = radiiAStep * Settings.SupportRadius / step;
            Assert.That(RobustLists.StepsAfter(Settings, step, 0.999 * speed), Is.EqualTo(expected));
        }

        [Test]
        public void WithoutListsEachStepSorts()
        {
            FluidSolverSettings settings = Settings.WithOwn((ref RobustSettings own) => own.NeighbourList = false);
            Assert.That(RobustLists.StepsAfter(settings, 0.01, 0.0), Is.Zero);
        }
    }
}
