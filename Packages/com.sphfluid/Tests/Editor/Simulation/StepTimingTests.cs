using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>The timer of a simulation's steps lives as long as anybody asks for it.</summary>
    public sealed class StepTimingTests
    {
        [Test]
        public void TheTimerIsThereFromTheFirstAskerToTheLast()
        {
            GpuTest.Require();
            using (var timing = new StepTiming())
            {
                Assert.That(timing.Timer, Is.Null);
                Assert.That(timing.TryEnd(null), Is.False, "nobody began");
                timing.Begin();
                StepTimer timer = timing.Timer;
                Assert.That(timer, Is.Not.Null);
                timing.Begin();
                Assert.That(timing.Timer, Is.SameAs(timer));
                Assert.That(timing.TryEnd(null), Is.True);
                Assert.That(timing.Timer, Is.SameAs(timer), "one still asks");
                Assert.That(timing.TryEnd(null), Is.True);
                Assert.That(timing.Timer, Is.Null);
                Assert.That(timing.TryEnd(null), Is.False);
            }
        }

        [Test]
        public void CostsThatAreNotUnderWayEndNothing()
        {
            GpuTest.Require();
            using (var timing = new StepTiming())
            {
                timing.Begin();
                timing.EndCosts(null);
                Assert.That(timing.Timer, Is.Not.Null);
                timing.BeginCosts();
                timing.EndCosts(null);
                Assert.That(timing.Timer, Is.Not.Null, "the first asker has not ended");
                timing.TryEnd(null);
                Assert.That(timing.Timer, Is.Null);
            }
        }
    }
}
