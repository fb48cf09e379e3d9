using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Each kind of guard is reported once, with its figure.</summary>
    public sealed class GuardMonitorTests
    {
        [Test]
        public void NothingActedSaysNothing()
        {
            Assert.That(new GuardMonitor().Note(default), Is.Null);
        }

        [Test]
        public void EachKindIsReportedOnce()
        {
            var monitor = new GuardMonitor();
            var counters = new FluidCounters { Squeezed = 2 };
            Assert.That(monitor.Note(counters), Does.Contain("2 times a particle had no place between colliders"));
            counters.Squeezed = 3;
            Assert.That(monitor.Note(counters), Is.Null);
        }
    }
}
