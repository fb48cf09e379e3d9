using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Samples come after whole steps, the nearest to their times.</summary>
    public sealed class CaseScheduleTests
    {
        [TestCase(1.0, 0.1, 0.03, 3, 7, 10, 13, 17, 20, 23, 27, 30, 33)]
        [TestCase(0.4, 0.1, 0.1, 1, 2, 3, 4)]
        [TestCase(0.5, 0.03, 0.1, 1, 2, 3, 4, 5)] // more samples than steps: one a step
        [TestCase(0.25, 1.0, 0.1, 2)]             // none but the end
        [TestCase(0.01, 1.0, 0.1, 1)]             // shorter than a step: one step
        public void SamplesComeAfterTheNearestSteps(double duration, double interval, double step, params int[] expected)
        {
            var schedule = new CaseSchedule(duration, interval, step);
            var found = new List<int>();
            for (long at = 0; at < schedule.LastStep; found.Add((int)at)) at = schedule.Next(at);

            Assert.That(found, Is.EqualTo(expected));
        }

        [Test]
        public void NoTimeDriftsOverALongRun()
        {
            const double Interval = 0.05, Step = 0.0237;
            var schedule = new CaseSchedule(2000, Interval, Step);
            long at = 0;
            for (int sample = 1; sample < 39999; sample++)
            {
                at = schedule.Next(at);
                Assert.That(at * Step, Is.EqualTo(sample * Interval).Within(0.5 * Step + 1e-9));
            }
        }

        [TestCase(0, 1, 1)]
        [TestCase(1, -1, 1)]
        [TestCase(1, 1, double.NaN)]
        [TestCase(double.PositiveInfinity, 1, 1)]
        public void TimesThatAreNoneAreNamed(double duration, double interval, double step) =>
            Assert.That(() => new CaseSchedule(duration, interval, step),
                Throws.ArgumentException.With.Message.Contains("positive number of seconds"));
    }
}
