using NUnit.Framework;
using SphFluid.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is said of a step's cost before Play: what was measured on this device, or that nothing was.</summary>
    public sealed class StepCostTests
    {
        [SetUp]
        public void SetUp() => StepCost.Forget();

        [TearDown]
        public void TearDown() => StepCost.Forget();

        [Test]
        public void NothingIsMadeUp()
        {
            Assert.That(StepCost.TryFind(FluidMethodKind.Standard, 10000, out _, out _), Is.False);
            if (StepTimer.IsSupported)
                Assert.That(DomainText.Estimate(FluidMethodKind.Standard, 10000, 10), Is.EqualTo("not measured on this device yet: press Play once"));
        }

        [Test]
        public void TheNearestNumberOfParticlesCounts()
        {
            StepCost.Note(FluidMethodKind.Standard, 1000, 40.0);
            StepCost.Note(FluidMethodKind.Standard, 60000, 4.0);
            Assert.That(Found(900), Is.EqualTo((40.0, 1024L)));
            Assert.That(Found(1), Is.EqualTo((40.0, 1024L)));
            Assert.That(Found(40000), Is.EqualTo((4.0, 65536L)));
            Assert.That(Found(5000000), Is.EqualTo((4.0, 65536L)));
            Assert.That(StepCost.TryFind(FluidMethodKind.Thesis, 1000, out _, out _), Is.False, "another method");
        }

        [Test]
        public void TheEstimateIsParticlesTimesStepsTimesCost()
        {
            StepCost.Note(FluidMethodKind.Standard, 16384, 5.0);
            // 20,000 particles, 11 steps, 5 ns: 1.1 ms.
            Assert.That(DomainText.Estimate(FluidMethodKind.Standard, 20000, 11.0), Is.EqualTo(
                $"about 1.10 ms for the steps, by the last run with some 16,384 particles on {SystemInfo.graphicsDeviceName}"));
        }

        [TestCase(0, 1.0)]
        [TestCase(10, 0.0)]
        [TestCase(10, double.NaN)]
        [TestCase(10, double.PositiveInfinity)]
        public void WrongMeasurementsAreNotKept(int particles, double nanoseconds)
        {
            StepCost.Note(FluidMethodKind.Standard, particles, nanoseconds);
            Assert.That(StepCost.TryFind(FluidMethodKind.Standard, 10, out _, out _), Is.False);
        }

        static (double, long) Found(long particles)
        {
            Assert.That(StepCost.TryFind(FluidMethodKind.Standard, particles, out double nanoseconds, out long with));
            return (nanoseconds, with);
        }
    }
}
