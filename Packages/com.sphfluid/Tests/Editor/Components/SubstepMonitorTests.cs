using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>The substep cap is told once an episode, with its figures.</summary>
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
        public void AnEpisodeIsToldOnceWithFigures()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.001, 50);
            string told = Note(monitor, clock, 0.1);
            Assert.That(told, Does.Contain("100 ms").And.Contain("needs 100 steps").And.Contain("1 ms").And.Contain("at most 50").And.Contain("50 %"));
            for (int frame = 0; frame < 20; frame++) Assert.That(Note(monitor, clock, 0.1), Is.Null);
            Assert.That(monitor.CapHits, Is.EqualTo(21));
            Assert.That(monitor.RealTimeFactor, Is.InRange(0.5, 0.6));
        }

        [Test]
        public void ANewEpisodeBeginsAfterAQuietSecond()
        {
            var monitor = new SubstepMonitor();
            var clock = new StepClock(0.001, 50);
            Assert.That(Note(monitor, clock, 0.1), Is.Not.Null);
            for (int frame = 0; frame < 10; frame++) Assert.That(Note(monitor, clock, 0.04), Is.Null);
            Assert.That(Note(monitor, clock, 0.1), Is.Null, "0.4 s is the same episode");
            for (int frame = 0; frame < 30; frame++) Assert.That(Note(monitor, clock, 0.04), Is.Null);
            Assert.That(Note(monitor, clock, 0.1), Is.Not.Null);
        }

        [Test]
        public void AFrameWithoutTimeIsNoFrame() => Assert.That(Note(new SubstepMonitor(), new StepClock(0.01, 1), 0.0), Is.Null);

        static string Note(SubstepMonitor monitor, StepClock clock, double deltaTime) =>
            monitor.Note(clock, clock.Advance(deltaTime), deltaTime);
    }
}
