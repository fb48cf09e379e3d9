using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class StepClockTests
    {
        [Test]
        public void WholeStepsAreGivenAndTheRestWaits()
        {
            var clock = new StepClock(0.25, 10);
            Assert.That(clock.Advance(0.6), Is.EqualTo(2));
            Assert.That(clock.Advance(0.1), Is.EqualTo(0));
            Assert.That(clock.Advance(0.1), Is.EqualTo(1));
            Assert.That(clock.SimulatedTime, Is.EqualTo(0.75));
            Assert.That(clock.DroppedTime, Is.EqualTo(0.0));
        }

        [Test]
        public void FramesOfThirtiethsDoNotDrift()
        {
            var clock = new StepClock(1.0 / 900.0, 100);
            for (int i = 0; i < 3000; i++) Assert.That(clock.Advance(1f / 30f), Is.EqualTo(30).Within(1), $"frame {i}");

            Assert.That(clock.StepCount, Is.EqualTo(90000).Within(1));
        }

        [Test]
        public void SurplusAtTheCapIsDroppedAndReported()
        {
            var clock = new StepClock(0.125, 4);
            Assert.That(clock.Advance(1.0625), Is.EqualTo(4));
            Assert.That(clock.LastDroppedTime, Is.EqualTo(0.5));
            Assert.That(clock.Advance(0.0625), Is.EqualTo(1), "the fraction of a step is kept");
            Assert.That(clock.LastDroppedTime, Is.EqualTo(0.0));
            Assert.That(clock.DroppedTime, Is.EqualTo(0.5));
            Assert.That(clock.SimulatedTime, Is.EqualTo(0.625));
        }

        [Test]
        public void AStepOutsideTheFramesLeavesTheRestWaiting()
        {
            var clock = new StepClock(0.25, 10);
            Assert.That(clock.Advance(0.375), Is.EqualTo(1));
            clock.StepOnce();
            Assert.That(clock.SimulatedTime, Is.EqualTo(0.5));
            Assert.That(clock.Advance(0.125), Is.EqualTo(1), "what waited and the frame make a step");
        }

        [Test]
        public void ResetReturnsToZero()
        {
            var clock = new StepClock(0.1, 1);
            clock.Advance(1.05);
            clock.Reset();
            Assert.That(clock.StepCount, Is.EqualTo(0));
            Assert.That(clock.DroppedTime, Is.EqualTo(0.0));
            Assert.That(clock.Advance(0.06), Is.EqualTo(0), "nothing is pending");
        }

        [TestCase(0.0, 1)]
        [TestCase(-1.0, 1)]
        [TestCase(double.NaN, 1)]
        [TestCase(double.PositiveInfinity, 1)]
        [TestCase(0.1, 0)]
        public void BadArgumentsAreRefused(double timeStep, int maxSteps)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new StepClock(timeStep, maxSteps));
        }

        [TestCase(-0.1)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void BadFrameTimeIsRefused(double deltaTime)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new StepClock(0.1, 1).Advance(deltaTime));
        }
    }
}
