using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class SpareSpeedTests
    {
        private const double Frame = 1.0 / 60.0;

        // A liquid for which a frame has so many of the longest steps, at 1 m/s and in proportion.
        private static Func<double, double> Liquid(double quotient) => speed => Frame / (quotient * speed);

        [TestCase(3.3, 4)]
        [TestCase(1.1, 2)]
        [TestCase(0.7, 1)]
        [TestCase(12.01, 13)]
        public void AFrameTakesTheSameStepsWithTheClocksMargin(double quotient, int steps)
        {
            double speed = SpareSpeed.For(Frame, 1.0, 100.0, 64, Liquid(quotient));
            Assert.That(speed, Is.EqualTo(steps / quotient / 1.05).Within(0.002));
            Assert.That(new AdaptiveClock(Liquid(quotient)(speed), 64).Advance(Frame), Is.EqualTo(steps));
            Assert.That(new AdaptiveClock(Liquid(quotient)(1.0), 64).Advance(Frame), Is.EqualTo(steps), "as many as for the lower speed");
        }

        [Test]
        public void WhereAFrameNeedsItsStepsTheLowerSpeedStays()
        {
            Assert.That(SpareSpeed.For(Frame, 1.0, 2.0, 64, Liquid(3.0)), Is.EqualTo(1.0), "whole steps");
            Assert.That(SpareSpeed.For(Frame, 1.0, 2.0, 64, Liquid(2.9)), Is.EqualTo(1.0), "within the clock's margin");
            Assert.That(SpareSpeed.For(Frame, 1.0, 2.0, 3, Liquid(3.3)), Is.EqualTo(1.0), "more steps than a frame may have");
            Assert.That(SpareSpeed.For(Frame, 1.0, 2.0, 64, Liquid(0.4)), Is.EqualTo(1.0), "a step for several frames");
        }

        [Test]
        public void ItIsNeverAboveTheHighest()
        {
            Assert.That(SpareSpeed.For(Frame, 1.0, 1.1, 64, Liquid(1.1)), Is.EqualTo(1.1).Within(1e-4).And.LessThanOrEqualTo(1.1));
            Assert.That(SpareSpeed.For(Frame, 3.0, 2.0, 64, Liquid(1.1)), Is.EqualTo(3.0));
        }

        [TestCase(0.02)]
        [TestCase(0.1)]
        [TestCase(0.3)]
        public void FramesOfUnequalLengthTakeHardlyMoreSteps(double flicker)
        {
            for (double quotient = 1.05; quotient < 8.0; quotient += 0.1)
            {
                var random = new Random(5);
                SpeedReference plain = new SpeedReference(10.0), spare = new SpeedReference(10.0);
                AdaptiveClock plainClock = new AdaptiveClock(Frame, 64), spareClock = new AdaptiveClock(Frame, 64);
                int before = 0, now = 0;
                for (int frame = 0; frame < 2000; frame++)
                {
                    double time = Frame * (1.0 + flicker * (random.NextDouble() - 0.5));
                    plain.Update(1.0, time);
                    spare.Update(1.0, time, spare: SpareSpeed.For(time, 1.0, 10.0, 64, Liquid(quotient)));
                    plainClock.StableStep = Liquid(quotient)(plain.Speed);
                    spareClock.StableStep = Liquid(quotient)(spare.Speed);
                    int plainSteps = plainClock.Advance(time), spareSteps = spareClock.Advance(time);
                    if (frame < 500) continue; // until both have come down
                    before += plainSteps;
                    now += spareSteps;
                }

                Assert.That(now, Is.LessThanOrEqualTo(1.06 * before), $"{quotient:0.00} steps");
            }
        }
    }
}
