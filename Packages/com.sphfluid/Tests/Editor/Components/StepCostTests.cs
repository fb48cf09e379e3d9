using NUnit.Framework;
using SphFluid.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is said of a step's cost before Play: what was measured on this device, or that nothing was.</summary>
    public sealed class StepCostTests
    {
        private static readonly StepCostKey Standard = StepCostKey.Create(FluidMethodKind.Standard, 2.25, false);

        [SetUp]
        public void SetUp() => StepCosts.Use(new StepCostTable());

        [TearDown]
        public void TearDown() => StepCosts.Use(null);

        [Test]
        public void NothingIsMadeUp()
        {
            Assert.That(StepCosts.TryFind(Standard, 10000, out _), Is.False);
            if (StepTimer.IsSupported)
            {
                Assert.That(DomainText.Estimate(Standard, 10000, 10),
                    Is.EqualTo("not measured on this device yet: look at it here in play"));
            }
        }

        [Test]
        public void TheEstimateIsStepsTimesCost()
        {
            StepCosts.Record(Standard, new StepCost { Particles = 16384, Milliseconds = 0.08, InPlay = true });
            // 20,480 particles, 11 steps: 0.08 · 1.25 · 11 = 1.1 ms.
            Assert.That(DomainText.Estimate(Standard, 20480, 11.0), Is.EqualTo(
                $"about 1.10 ms for the steps, by the last run with 16,384 particles on {SystemInfo.graphicsDeviceName}"));
        }

        [Test]
        public void OnlyCostsOfThisDeviceAndVersionAreTakenUp()
        {
            var costs = new StepCostTable();
            costs.Record(Standard, new StepCost { Particles = 1000, Milliseconds = 0.123456789, InPlay = true });
            string packed = StepCosts.Pack(costs);
            Assert.That(StepCosts.Unpack(packed).TryFind(Standard, 1000, out StepCost found) && found.Milliseconds == 0.123456789 &&
                found.InPlay);
            Assert.That(StepCosts.Unpack(packed.Replace(FluidPackage.Version, "0.0.9")).Count, Is.Zero, "another version");
            Assert.That(StepCosts.Unpack(packed.Replace(SystemInfo.graphicsDeviceName, "Other")).Count, Is.Zero, "another device");
            Assert.That(StepCosts.Unpack("").Count, Is.Zero);
            Assert.That(StepCosts.Unpack(packed + "Standard.1/2.25/free x y play\nrubbish\n").Count, Is.EqualTo(1));
        }
    }
}
