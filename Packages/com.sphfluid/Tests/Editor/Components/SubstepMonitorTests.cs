using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>An overload that lasts is reported once an episode, with its figures; a single long frame is not.</summary>
    public sealed class SubstepMonitorTests
    {
        [Test]
        public void KeepingUpSaysNothing()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.01, 10);
            for (int frame = 0; frame < 50; frame++) Assert.That(Note(monitor, clock, 0.1), Is.Null);
            Assert.That(monitor.CapHits, Is.Zero);
            Assert.That(monitor.RealTimeFactor, Is.EqualTo(1.0).Within(1e-9));
        }

        [Test]
        public void AnEpisodeIsReportedOnceWithFigures()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.001, 50);
            Assert.That(CappedFramesUntilReport(monitor, clock, 0.1, out string report), Is.EqualTo(SubstepMonitor.StartFrames + 5));
            Assert.That(report, Does.Contain("100 ms").And.Contain("needs 100 steps").And.Contain("1 ms").And.Contain("at most 50")
                .And.Contain("50 %").And.Contain("8 such frames"));
            for (int frame = 0; frame < 20; frame++) Assert.That(Note(monitor, clock, 0.1), Is.Null);
            Assert.That(monitor.CapHits, Is.EqualTo(28));
            Assert.That(monitor.RealTimeFactor, Is.InRange(0.5, 0.6));
        }

        [TestCase(0.0167, 0.004, ExpectedResult = 30)] // 60 frames a second, each of 17 steps where 4 are allowed
        [TestCase(0.06, 0.05, ExpectedResult = 9)]
        [TestCase(0.333, 0.064, ExpectedResult = 5)] // a long frame counts for a tenth of a second
        public int AnOverloadOfHalfASecondIsReported(double frame, double allowed)
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.001, (int)(allowed * 1000));
            return CappedFramesUntilReport(monitor, clock, frame, out _) - SubstepMonitor.StartFrames;
        }

        [Test]
        public void OneLongFrameIsCountedButNotReported()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.00125, 64);
            for (int frame = 0; frame < 200; frame++)
            {
                Assert.That(Note(monitor, clock, frame % 70 == 10 ? 0.3333 : 0.0167), Is.Null, $"frame {frame}");
            }
            Assert.That(monitor.CapHits, Is.EqualTo(3));
        }

        [Test]
        public void LongFramesThatKeepComingAreReported()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.00125, 64);
            int frame = 0;
            while (frame < 1000 && Note(monitor, clock, frame % 20 == 10 ? 0.3333 : 0.0167) == null) frame++;
            Assert.That(frame, Is.EqualTo(90), "the fifth");
        }

        [Test]
        public void LongFramesAfterAStartAreNotReported()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.00125, 64);
            for (int frame = 0; frame < SubstepMonitor.StartFrames; frame++) Assert.That(Note(monitor, clock, 2.0), Is.Null);
            for (int frame = 0; frame < 100; frame++) Assert.That(Note(monitor, clock, 0.0167), Is.Null);
            Assert.That(monitor.CapHits, Is.EqualTo(SubstepMonitor.StartFrames));
        }

        [Test]
        public void ANewEpisodeBeginsAfterAQuietSecond()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.001, 50);
            CappedFramesUntilReport(monitor, clock, 0.1, out _);
            for (int frame = 0; frame < 10; frame++) Assert.That(Note(monitor, clock, 0.04), Is.Null);
            for (int frame = 0; frame < 10; frame++) Assert.That(Note(monitor, clock, 0.1), Is.Null, "0.4 s is the same episode");
            for (int frame = 0; frame < 30; frame++) Assert.That(Note(monitor, clock, 0.04), Is.Null);
            Assert.That(CappedFramesUntilReport(monitor, clock, 0.1, out _), Is.EqualTo(5));
        }

        [Test]
        public void AFrameWithoutTimeIsNoFrame() => Assert.That(Note(new SubstepMonitor(), new StepClock(0.01, 1), 0.0), Is.Null);

        private static int CappedFramesUntilReport(SubstepMonitor monitor, StepClock clock, double deltaTime, out string report)
        {
            for (int frame = 1; frame <= 1000; frame++)
            {
                report = Note(monitor, clock, deltaTime);
                if (report != null) return frame;
            }
            report = null;
            return -1;
        }

        private static string Note(SubstepMonitor monitor, StepClock clock, double deltaTime) =>
            monitor.Update(clock, clock.Advance(deltaTime), deltaTime);
    }
}
