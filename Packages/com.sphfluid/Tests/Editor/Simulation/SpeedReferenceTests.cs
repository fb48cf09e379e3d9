using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class SpeedReferenceTests
    {
        private const double Frame = 1.0 / 60.0;

        [Test]
        public void ItFallsSlowlyToTheMeasuredSpeed()
        {
            var reference = new SpeedReference(4.0);
            for (int frame = 0; frame < 60; frame++)
            {
                double before = reference.Speed;
                Assert.That(reference.Update(1.0, Frame));
                Assert.That(reference.Speed, Is.EqualTo(before * Math.Exp(-Frame)).Within(1e-12));
            }
            Assert.That(reference.Speed, Is.EqualTo(4.0 / Math.E).Within(1e-9), "a factor e a second");
            for (int frame = 0; frame < 60; frame++) reference.Update(1.0, Frame);
            Assert.That(reference.Speed, Is.EqualTo(1.0));
            Assert.That(reference.Update(1.0, Frame), Is.False);
        }

        [Test]
        public void ItRisesFasterAndNeverAboveTheRule()
        {
            var reference = new SpeedReference(4.0);
            for (int frame = 0; frame < 300; frame++) reference.Update(1.0, Frame);
            Assert.That(reference.Update(100.0, Frame));
            Assert.That(reference.Speed, Is.EqualTo(Math.Exp(10.0 * Frame)).Within(1e-12));
            for (int frame = 0; frame < 300; frame++) reference.Update(double.PositiveInfinity, Frame);
            Assert.That(reference.Speed, Is.EqualTo(4.0));
        }

        [Test]
        public void CollidersRaiseItAboveTheRuleAndAtOnceWhereNothingIsPressed()
        {
            var reference = new SpeedReference(0.1);
            reference.Update(0.1, Frame, 3.0);
            Assert.That(reference.Speed, Is.EqualTo(0.1 * Math.Exp(10.0 * Frame)).Within(1e-12), "a speed: as pressure can follow");
            reference.Update(0.1, Frame, 3.0, 2.0, 1000.0);
            Assert.That(reference.Speed, Is.EqualTo(2.0), "the part by acceleration, of liquid without pressure");
            reference.Update(0.1, Frame, 9.0, 9.0, 1.5);
            Assert.That(reference.Speed, Is.EqualTo(3.0), "no more than its pressure allows");
            for (int frame = 0; frame < 600; frame++) reference.Update(100.0, Frame);
            Assert.That(reference.Speed, Is.EqualTo(0.1).Within(1e-9), "back to the rule");
        }

        [Test]
        public void AFlickerByABinIsNoChange()
        {
            var reference = new SpeedReference(2.0);
            for (int frame = 0; frame < 60; frame++) Assert.That(reference.Update(frame % 2 == 0 ? 2.0 : 1.9, Frame), Is.False);
            Assert.That(reference.Update(1.8, Frame));
        }

        [Test]
        public void AFrameThatTookLongIsNoLeap()
        {
            var reference = new SpeedReference(2.0);
            reference.Update(0.1, 30.0);
            Assert.That(reference.Speed, Is.EqualTo(2.0 * Math.Exp(-0.1)).Within(1e-12));
        }

        [Test]
        public void AnotherRuleRaisesItAtOnceAndLimitsIt()
        {
            var reference = new SpeedReference(2.0);
            for (int frame = 0; frame < 300; frame++) reference.Update(1.0, Frame);
            reference.Limit(6.0);
            Assert.That(reference.Speed, Is.EqualTo(3.0).Within(1e-12), "in proportion");
            reference.Limit(2.5);
            Assert.That(reference.Speed, Is.EqualTo(2.5));
            reference.Limit(5.0);
            reference.Restart();
            Assert.That(reference.Speed, Is.EqualTo(5.0));
        }

        [Test]
        public void ItFallsNoFartherThanWhereFramesTakeFewerSteps()
        {
            var reference = new SpeedReference(4.0);
            for (int frame = 0; frame < 120; frame++) reference.Update(1.0, Frame, spare: 1.5);
            Assert.That(reference.Speed, Is.EqualTo(1.5));
            for (int frame = 0; frame < 60; frame++) reference.Update(1.0, Frame, spare: 1.3);
            Assert.That(reference.Speed, Is.EqualTo(1.3));
        }

        [Test]
        public void ToWhatNothingNeedsItRisesSlowlyAndNeverAboveTheRule()
        {
            var reference = new SpeedReference(4.0);
            for (int frame = 0; frame < 120; frame++) reference.Update(1.0, Frame);
            Assert.That(reference.Update(1.0, Frame, spare: 9.0));
            Assert.That(reference.Speed, Is.EqualTo(Math.Exp(Frame / 6.0)).Within(1e-12));
            for (int frame = 0; frame < 1000; frame++) reference.Update(1.0, Frame, spare: 9.0);
            Assert.That(reference.Speed, Is.EqualTo(4.0));
            for (int frame = 0; frame < 300; frame++) reference.Update(1.0, Frame);
            Assert.That(reference.Update(3.0, Frame, spare: 3.5));
            Assert.That(reference.Speed, Is.EqualTo(Math.Exp(10.0 * Frame)).Within(1e-12), "what is needed comes at once");
        }
    }
}
