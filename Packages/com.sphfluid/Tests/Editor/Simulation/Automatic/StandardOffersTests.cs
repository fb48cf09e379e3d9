using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the Standard method offers Automatic: the profile's compression, and three times as much in fewer steps.</summary>
    public sealed class StandardOffersTests
    {
        [Test]
        public void TheFirstOfferIsAsTheProfileAsksAndTheSecondThreeTimesAsSoft()
        {
            FluidRuleInput input = Input(0.01f, 10f);
            var offers = StandardOffers.For(Question(input));
            Assert.That(offers.Count, Is.EqualTo(2));
            Assert.That((offers[0].MaxCompression, offers[0].SoundSpeedRatio, offers[0].AsTheProfileAsks), Is.EqualTo((0.01f, 10f, true)));
            Assert.That(offers[1].MaxCompression, Is.EqualTo(0.03f).Within(1e-7f));
            Assert.That(offers[1].SoundSpeedRatio, Is.EqualTo(10f / Mathf.Sqrt(3f)).Within(1e-5f));
            Assert.That(offers[0].SoundSpeed / offers[1].SoundSpeed, Is.EqualTo(System.Math.Sqrt(3.0)).Within(1e-5));
        }

        [Test]
        public void StepsAreThoseThatFillAFrame()
        {
            FluidRuleInput input = Input(0.04f, 5f);
            MethodOffer offer = StandardOffers.For(Question(input))[0];
            double step = FluidRules.Derive(offer.Apply(input)).TimeStep;
            Assert.That(offer.StepsAFrame * step, Is.GreaterThanOrEqualTo(1.0 / 60.0 * (1.0 - 1e-6)));
            Assert.That((offer.StepsAFrame - 1.0) * step, Is.LessThan(1.0 / 60.0));
        }

        [Test]
        public void SofterIsNeverSofterThanAProfileMayBe()
        {
            MethodOffer soft = StandardOffers.For(Question(Input(0.1f, 4f)))[1];
            Assert.That(soft.MaxCompression, Is.EqualTo(0.2f));
            Assert.That(soft.SoundSpeedRatio, Is.EqualTo(3f));
        }

        [Test]
        public void ALiquidThatCannotBeSofterHasOneOffer()
        {
            var offers = StandardOffers.For(Question(Input(0.2f, 3f)));
            Assert.That(offers.Count, Is.EqualTo(1));
            Assert.That(offers[0].AsTheProfileAsks);
        }

        [Test]
        public void AFixedStepHasOneOffer()
        {
            FluidRuleInput input = Input(0.04f, 5f);
            input.FixedTimeStep = 0.001f; // 17 fill a frame of 16.7 ms, however soft the liquid is
            var offers = StandardOffers.For(Question(input));
            Assert.That(offers.Count, Is.EqualTo(1));
            Assert.That(offers[0].StepsAFrame, Is.EqualTo(17.0));
        }

        [Test]
        public void OnlyMethodsForUseAreOffered()
        {
            foreach (FluidMethod method in FluidMethods.All)
            {
                bool offers = method.Offers(Question(Input(0.04f, 5f))).Count > 0;
                Assert.That(offers, Is.EqualTo(method.MayBePicked), $"{method.Kind}");
                Assert.That(method.MayBePicked, Is.EqualTo(!method.Has(FluidMethodFeatures.PenaltyWalls)),
                    $"{method.Kind}: those of the thesis are for comparison");
                Assert.That(method.PassesAStep, Is.GreaterThanOrEqualTo(2.0));
            }
        }

        private static MethodQuestion Question(FluidRuleInput input) =>
            new MethodQuestion { Input = input, FrameTime = 1.0 / 60.0, Affordable = double.NaN };

        private static FluidRuleInput Input(float compression, float ratio)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            (input.DomainSize, input.Spacing, input.LiquidHeight, input.LiquidDepth) = (Vector3.one, 0.02f, 0.4f, 0.4f);
            (input.MaxCompression, input.SoundSpeedRatio) = (compression, ratio);
            return input;
        }
    }
}
