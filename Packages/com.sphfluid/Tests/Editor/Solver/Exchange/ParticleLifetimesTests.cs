using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Which ids leave when.</summary>
    public sealed class ParticleLifetimesTests
    {
        [Test]
        public void RangesAreTakenInTheStepInWhichTheirTimeEnds()
        {
            var lifetimes = new ParticleLifetimes();
            lifetimes.Add(10u, 5u, 0.3);
            lifetimes.Add(15u, 2u, 0.1);
            lifetimes.Add(17u, 0u, 0.1);
            Assert.That(lifetimes.Waiting, Is.EqualTo(2), "an empty one is none");
            Assert.That(lifetimes.RemoveDue(0.09, 100u), Is.Zero);
            Assert.That(lifetimes.RemoveDue(0.1, 100u), Is.EqualTo(1));
            Assert.That((lifetimes.Due[1].First, lifetimes.Due[1].Count), Is.EqualTo((15u, 2u)));
            Assert.That(lifetimes.RemoveDue(0.2, 100u), Is.Zero);
            Assert.That(lifetimes.RemoveDue(0.35, 100u), Is.EqualTo(1));
            Assert.That(lifetimes.Due[1].First, Is.EqualTo(10u));
            Assert.That(lifetimes.Waiting, Is.Zero);
            Assert.That(lifetimes.RemoveDue(9.0, 100u), Is.Zero);
        }

        // Ids wrap: 1 is born after 0xffffffff.
        [TestCase(14u, 10u, 0)]
        [TestCase(15u, 10u, 1)]
        [TestCase(3u, 0xfffffffeu, 1)]
        [TestCase(2u, 0xfffffffeu, 0)]
        public void WhoIsNotBornYetWaits(uint unborn, uint first, int taken)
        {
            var lifetimes = new ParticleLifetimes();
            lifetimes.Add(first, 5u, 0.1);
            Assert.That(lifetimes.RemoveDue(0.2, unborn), Is.EqualTo(taken));
            Assert.That(lifetimes.Waiting, Is.EqualTo(1 - taken));
            Assert.That(lifetimes.RemoveDue(0.3, unchecked(first + 5u)), Is.EqualTo(1 - taken));
        }

        [Test]
        public void NoRangeIsForgottenWhereMoreAreDueThanASortTakes()
        {
            var lifetimes = new ParticleLifetimes();
            const int count = 2 * ParticleLifetimes.MostDue + 3;
            for (uint i = 0; i < count; i++) lifetimes.Add(i, 1u, 0.1);
            var seen = Enumerable.Empty<uint>();
            for (int sort = 0; sort < 3; sort++)
            {
                int taken = lifetimes.RemoveDue(0.2, 1000u);
                Assert.That(taken, Is.EqualTo(sort < 2 ? ParticleLifetimes.MostDue : 3));
                Assert.That(lifetimes.Due[0].First, Is.EqualTo(taken));
                seen = seen.Concat(lifetimes.Due.Skip(1).Take(taken).Select(r => r.First).ToArray());
            }
            Assert.That(seen, Is.EqualTo(Enumerable.Range(0, count).Select(i => (uint)i)));
        }
    }
}
