using System;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class SessionRateTests
    {
        private static TimeSpan Seconds(double seconds) => TimeSpan.FromSeconds(seconds);

        [Test]
        public void NothingIsKnownWithoutExpectationAndMeasurement()
        {
            Assert.That(new SessionRate(null).TimeFor(10.0), Is.Null);
        }

        [Test]
        public void WhatIsExpectedHoldsUntilSomethingIsMeasured()
        {
            var rate = new SessionRate(null);
            rate.Expect(5.0);

            Assert.That(rate.TimeFor(10.0).Value.TotalSeconds, Is.EqualTo(2.0).Within(1e-6));
        }

        [Test]
        public void AFirstJobThatOnlyCompiledDoesNotDecide()
        {
            var rate = new SessionRate(1000.0);
            // A hundredth of a second's work that took a second.
            rate.Add(10.0, Seconds(1.0));

            // What is expected counts like four seconds: (10 + 4 × 1000) / (1 + 4) = 802 a second.
            Assert.That(rate.TimeFor(802.0).Value.TotalSeconds, Is.EqualTo(1.0).Within(1e-6));
        }

        [Test]
        public void ManyJobsDecide()
        {
            var rate = new SessionRate(1000.0);
            for (int i = 0; i < 100; i++) rate.Add(100.0, Seconds(1.0));

            Assert.That(rate.TimeFor(100.0).Value.TotalSeconds, Is.EqualTo(1.0).Within(0.3));
        }

        [Test]
        public void AKindIsComparedWithItself()
        {
            var rate = new SessionRate(null);
            rate.Add(100.0, Seconds(100.0), "slow");
            rate.Add(100.0, Seconds(10.0), "fast");

            Assert.That(rate.TimeFor(100.0, "slow").Value.TotalSeconds, Is.EqualTo(100.0).Within(5).Percent);
            Assert.That(rate.TimeFor(100.0, "fast").Value.TotalSeconds, Is.EqualTo(10.0).Within(10).Percent);
            Assert.That(rate.TimeFor(200.0, "unknown").Value.TotalSeconds, Is.EqualTo(110.0).Within(1).Percent, "as all together");
        }

        [Test]
        public void TheRunningJobCountsAndIsReplacedByItsResult()
        {
            var rate = new SessionRate(null);
            rate.Running(50.0, Seconds(5.0));
            Assert.That(rate.TimeFor(100.0).Value.TotalSeconds, Is.EqualTo(10.0).Within(1e-6));
            rate.Running(60.0, Seconds(12.0));
            Assert.That(rate.TimeFor(100.0).Value.TotalSeconds, Is.EqualTo(20.0).Within(1e-6));
            rate.Add(100.0, Seconds(30.0));
            Assert.That(rate.TimeFor(100.0).Value.TotalSeconds, Is.EqualTo(30.0).Within(1e-6));
        }

        [TestCase(1.0, "about 5 s")]
        [TestCase(42.0, "about 40 s")]
        [TestCase(94.0, "about 95 s")]
        [TestCase(100.0, "about 2 min")]
        [TestCase(60.0 * 89, "about 89 min")]
        [TestCase(60.0 * 90, "about 1 h 30 min")]
        [TestCase(3600.0 * 3, "about 3 h")]
        public void TimesAreSaidAsPeopleDo(double seconds, string said)
        {
            Assert.That(SessionProgress.About(Seconds(seconds)), Is.EqualTo(said));
        }
    }
}
