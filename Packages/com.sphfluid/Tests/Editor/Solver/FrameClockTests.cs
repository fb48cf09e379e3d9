using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class FrameClockTests
    {
        private const double Longest = 1.0 / 120.0;

        private static FrameClock Clock(int most = 64) => new FrameClock(4, Longest, most, 1.0 / 240.0);

        [TestCase(1.0 / 240.0)]
        [TestCase(1.0 / 60.0)]
        [TestCase(0.0213)]
        [TestCase(1.0 / 30.0)]
        public void AFrameIsFourEqualStepsHoweverLong(double frame)
        {
            FrameClock clock = Clock();
            Assert.That(clock.Advance(frame), Is.EqualTo(4));
            Assert.That(clock.TimeStep, Is.EqualTo(0.25 * frame));
            Assert.That(clock.LastDroppedTime, Is.Zero);
        }

        [TestCase(0.05, 6)]
        [TestCase(0.3334, 41)]
        public void ALongFrameHasMoreStepsThatFillIt(double frame, int steps)
        {
            FrameClock clock = Clock();
            Assert.That(clock.Advance(frame), Is.EqualTo(steps));
            Assert.That(steps * clock.TimeStep, Is.EqualTo(frame).Within(1e-12));
            Assert.That(clock.TimeStep, Is.LessThanOrEqualTo(Longest));
        }

        [Test]
        public void WhatIsBeyondTheMostIsDropped()
        {
            FrameClock clock = Clock(16);
            Assert.That(clock.Advance(0.2), Is.EqualTo(16));
            Assert.That(clock.TimeStep, Is.EqualTo(Longest));
            Assert.That(clock.LastDroppedTime, Is.EqualTo(0.2 - 16 * Longest).Within(1e-12));
            Assert.That(clock.Advance(1.0 / 60.0), Is.EqualTo(4), "nothing waits");
            Assert.That(clock.LastDroppedTime, Is.Zero);
        }

        [Test]
        public void FewerThanItsStepsAreNeverAllowed()
        {
            FrameClock clock = Clock(1);
            Assert.That(clock.MaxSteps, Is.EqualTo(4));
            Assert.That(clock.Advance(1.0 / 60.0), Is.EqualTo(4));
        }

        [Test]
        public void NoTimeTakesNoStep()
        {
            FrameClock clock = Clock();
            Assert.That(clock.Advance(0.0), Is.Zero);
            Assert.That(clock.TimeStep, Is.EqualTo(1.0 / 240.0));
        }

        [Test]
        public void AStepOutsideTheFramesIsAsLongAsTheLast()
        {
            FrameClock clock = Clock();
            clock.Advance(0.02);
            clock.StepOnce();
            Assert.That(clock.TimeStep, Is.EqualTo(0.005));
        }

        [Test]
        public void TheLongestStepOfLateIsForgottenSlowly()
        {
            FrameClock clock = Clock();
            clock.Advance(0.03);
            Assert.That(clock.LongestOfLate, Is.EqualTo(0.0075));
            for (int i = 0; i < 10; i++) clock.Advance(0.02);
            Assert.That(clock.LongestOfLate, Is.EqualTo(0.0075 * Math.Pow(0.99, 10)).Within(1e-9));
            for (int i = 0; i < 100; i++) clock.Advance(0.02);
            Assert.That(clock.LongestOfLate, Is.EqualTo(0.005));
        }

        [TestCase(-1.0)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void TimesThatAreNoneAreRefused(double frame) => Assert.Throws<ArgumentOutOfRangeException>(() => Clock().Advance(frame));

        [Test]
        public void ClocksAreMadeOfPositiveNumbers()
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new FrameClock(0, Longest, 4, 0.01));
            Assert.Throws<ArgumentOutOfRangeException>(() => new FrameClock(4, 0.0, 4, 0.01));
            Assert.Throws<ArgumentOutOfRangeException>(() => new FrameClock(4, Longest, 4, double.NaN));
        }
    }
}
