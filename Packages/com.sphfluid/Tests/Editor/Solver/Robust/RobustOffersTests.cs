using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the Robust method offers Automatic: as many substeps as the budget holds.</summary>
    public sealed class RobustOffersTests
    {
        private static readonly FluidMethod Robust = FluidMethods.Get(FluidMethodKind.Robust);

        [TestCase(double.NaN, 4)]
        [TestCase(0.0, 4)]
        [TestCase(1.0, 4)]
        [TestCase(4.9, 4)]
        [TestCase(5.0, 5)]
        [TestCase(7.99, 7)]
        [TestCase(1000.0, RobustOffers.MostSubsteps)]
        [TestCase(double.PositiveInfinity, RobustOffers.MostSubsteps)]
        public void AsManySubstepsAsTheBudgetHolds(double affordable, int expected)
        {
            MethodOffer offer = Offer(Input(), affordable); // slow: 2 iterations at any number of substeps
            Assert.That(offer.Substeps, Is.EqualTo(expected));
            Assert.That(offer.StepsAFrame, Is.EqualTo((double)expected));
            Assert.That(offer.CostRatio, Is.EqualTo(1.0).Within(1e-12));
        }

        [Test]
        public void NoFewerThanTheProfiles()
        {
            FluidRuleInput input = Input();
            input.Substeps = 6;
            Assert.That(Offer(input, 1.0).Substeps, Is.EqualTo(6));
        }

        [Test]
        public void MoreSubstepsAreStiffer()
        {
            Assert.That(Offer(Input(), 8.0).SoundSpeed, Is.GreaterThan(1.15 * Offer(Input(), 4.0).SoundSpeed));
        }

        [Test]
        public void FastLiquidCostsMoreASubstep()
        {
            FluidRuleInput input = Input();
            input.InitialSpeed = 12f; // 2.5 dx in 1/240 s: 4 iterations, 9 passes instead of 5
            Assert.That(Offer(input, double.NaN).CostRatio, Is.EqualTo(9.0 / 5.0).Within(1e-9));
        }

        [Test]
        public void AFixedStepLeavesNothingToChoose()
        {
            FluidRuleInput input = Input();
            input.FixedTimeStep = 0.002f;
            MethodOffer offer = Offer(input, 100.0);
            Assert.That((offer.Substeps, offer.StepsAFrame), Is.EqualTo((0, 9.0)));
        }

        [Test]
        public void DeepLiquidIsTooSoftForFewSubsteps()
        {
            FluidRuleInput shallow = Input(), deep = Input();
            (deep.LiquidHeight, deep.LiquidDepth, deep.DomainSize) = (4f, 4f, new Vector3(1f, 5f, 1f));
            Assert.That(Offer(shallow, double.NaN).SoundSpeed, Is.GreaterThan(Offer(shallow, double.NaN).LeastSoundSpeed));
            Assert.That(Offer(deep, double.NaN).SoundSpeed, Is.LessThan(Offer(deep, double.NaN).LeastSoundSpeed));
        }

        private static MethodOffer Offer(FluidRuleInput input, double affordable) =>
            RobustOffers.For(Robust, new MethodQuestion { Input = input, FrameTime = 1.0 / 60.0, Affordable = affordable });

        private static FluidRuleInput Input()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            (input.DomainSize, input.Spacing, input.LiquidHeight, input.LiquidDepth) = (Vector3.one, 0.02f, 0.1f, 0.1f);
            return input;
        }
    }
}
