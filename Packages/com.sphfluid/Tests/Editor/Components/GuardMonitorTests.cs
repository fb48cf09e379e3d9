using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Each kind of guard is reported once, with its figure.</summary>
    public sealed class GuardMonitorTests
    {
        [Test]
        public void NothingActedSaysNothing()
        {
            Assert.That(new GuardMonitor().Update(default, ""), Is.Null);
        }

        [Test]
        public void EachKindIsReportedOnce()
        {
            var monitor = new GuardMonitor();
            var counters = new FluidCounters { Squeezed = 2 };
            Assert.That(monitor.Update(counters, ""), Does.Contain("2 times a particle had no place between colliders"));
            counters.Squeezed = 3;
            Assert.That(monitor.Update(counters, ""), Is.Null);
        }

        [Test]
        public void EachKindHasItsOwnCure()
        {
            var monitor = new GuardMonitor();
            monitor.Update(new FluidCounters { Squeezed = 2 }, "Shorter steps");
            Assert.That(monitor.Cure, Does.StartWith("Stop colliders that close").And.Not.Contain("Shorter steps"), "no step parts them");
            monitor.Update(new FluidCounters { Squeezed = 2, Overlaps = 1 }, "Shorter steps");
            Assert.That(monitor.Cure, Is.EqualTo("Enable and place colliders where no liquid is."));
            monitor.Update(new FluidCounters { Squeezed = 2, Overlaps = 1, NonFinite = 1, ShortenedSteps = 1 }, "Shorter steps");
            Assert.That(monitor.Cure, Does.StartWith("Shorter steps, or raise Expected Speed"));
        }
    }
}
