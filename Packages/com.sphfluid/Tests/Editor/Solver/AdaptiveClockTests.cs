using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class AdaptiveClockTests
    {
        [TestCase(0.1, 0.03, 4)]
        [TestCase(0.1, 0.025, 4)]
        [TestCase(0.1, 0.1, 1)]
        [TestCase(0.1, 0.19, 1)]
        [TestCase(1.0 / 60.0, 0.00053, 32)]
        public void TheFewestEqualStepsFillTheFrame(double frame, double stable, int steps)
        {
            var clock = new AdaptiveClock(stable, 1000);
            Assert.That(clock.Advance(frame), Is.EqualTo(steps));
            Assert.That(steps * clock.TimeStep, Is.EqualTo(frame).Within(1e-15));
            Assert.That(clock.TimeStep, Is.LessThanOrEqualTo(stable * 1.000001));
            Assert.That(clock.LastDroppedTime, Is.Zero);
        }

        [Test]
        public void FramesOfEveryLengthAreFilledBySafeSteps()
        {
            var clock = new AdaptiveClock(0.004, 1000);
            var random = new Random(7);
            double given = 0.0, taken = 0.0;
            for (int frame = 0; frame < 1000; frame++)
            {
                double time = 0.03 * random.NextDouble();
                clock.StableStep = 0.003 + 0.002 * random.NextDouble();
                int steps = clock.Advance(time);
                given += time;
                taken += steps * clock.TimeStep;
                if (steps == 0) continue;
                Assert.That(clock.TimeStep, Is.LessThanOrEqualTo(clock.StableStep * 1.000001));
                Assert.That(clock.TimeStep, Is.GreaterThan(0.4 * 0.003));
            }
            Assert.That(taken, Is.EqualTo(given).Within(0.0025), "up to half a step waits");
        }

        [Test]
        public void FramesShorterThanHalfAStepWait()
        {
            var clock = new AdaptiveClock(0.01, 10);
            Assert.That(clock.Advance(0.002), Is.Zero);
            Assert.That(clock.Advance(0.002), Is.Zero);
            Assert.That(clock.Advance(0.002), Is.EqualTo(1));
            Assert.That(clock.TimeStep, Is.EqualTo(0.006).Within(1e-15));
        }

        [Test]
        public void AFrameWithoutTimeTakesNoStep()
        {
            var clock = new AdaptiveClock(0.01, 10);
            Assert.That(clock.Advance(0.0), Is.Zero);
            Assert.That(clock.TimeStep, Is.EqualTo(0.01));
            Assert.That(clock.LastDroppedTime, Is.Zero);
        }

        [Test]
        public void AtTheCapStepsKeepTheirLengthAndTimeIsDropped()
        {
            var clock = new AdaptiveClock(0.01, 4);
            Assert.That(clock.Advance(0.1), Is.EqualTo(4));
            Assert.That(clock.TimeStep, Is.EqualTo(0.01));
            Assert.That(clock.LastDroppedTime, Is.EqualTo(0.06).Within(1e-15));
            Assert.That(clock.Advance(0.04), Is.EqualTo(4), "what was dropped is gone");
            Assert.That(clock.LastDroppedTime, Is.Zero);
        }

        [Test]
        public void StepsShortenAtOnceAndLengthenSlowly()
        {
            var clock = new AdaptiveClock(0.01, 1000);
            Assert.That(clock.Advance(0.1), Is.EqualTo(10));
            clock.StableStep = 0.005;
            Assert.That(clock.Advance(0.1), Is.EqualTo(20));
            clock.StableStep = 0.01;
            int frames = 0, last = 20;
            while (last > 11)
            {
                int steps = clock.Advance(0.1);
                Assert.That(steps, Is.InRange(last - 1, last), $"frame {frames}");
                last = steps;
                Assert.That(++frames, Is.LessThan(100));
            }
            Assert.That(frames, Is.GreaterThan(25), "2 % a frame");
        }

        [Test]
        public void AFlickeringSpeedDoesNotFlickerTheSteps()
        {
            var clock = new AdaptiveClock(0.0102, 1000);
            var random = new Random(3);
            clock.StableStep = 0.00995;
            int first = clock.Advance(0.1);
            for (int frame = 0; frame < 200; frame++)
            {
                clock.StableStep = 0.00995 + 0.0004 * random.NextDouble();
                Assert.That(clock.Advance(0.1), Is.EqualTo(first), "11 steps, though 10 would do in half of the frames");
            }
        }

        [TestCase(0.0, 1)]
        [TestCase(double.NaN, 1)]
        [TestCase(double.PositiveInfinity, 1)]
        [TestCase(0.1, 0)]
        public void BadArgumentsAreRefused(double stable, int maxSteps)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new AdaptiveClock(stable, maxSteps));
        }

        [TestCase(-0.1)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void BadFrameTimeIsRefused(double deltaTime)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new AdaptiveClock(0.1, 1).Advance(deltaTime));
        }
    }
}
