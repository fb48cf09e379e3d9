using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Each kind of guard is told once, with its figure.</summary>
    public sealed class GuardMonitorTests
    {
        [Test]
        public void NothingActedSaysNothing()
        {
            Assert.That(new GuardMonitor().Note(default, 0), Is.Null);
        }

        [Test]
        public void EachKindIsToldOnce()
        {
            var monitor = new GuardMonitor();
            Assert.That(monitor.Note(default, 2), Does.Contain("2 times a collider moved farther"));
            Assert.That(monitor.Note(default, 3), Is.Null);
        }
    }
}
