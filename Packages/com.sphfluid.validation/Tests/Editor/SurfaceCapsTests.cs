using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class SurfaceCapsTests
    {
        [Test]
        public void WorstFramesAreKept()
        {
            var caps = new SurfaceCaps();
            caps.Observe(default); // nothing was read back yet
            caps.Observe(Status(blocks: 10, complete: false, openFaces: 2));
            caps.Observe(Status(blocks: 10, complete: true, nonFinite: 7));
            caps.Observe(Status(blocks: 0, complete: true));
            caps.Observe(Status(blocks: 12, complete: false));

            Assert.That(caps.StaleFrames, Is.EqualTo(2));
            Assert.That(caps.OpenFaces, Is.EqualTo(2));
            Assert.That(caps.SkippedParticles, Is.EqualTo(7));
        }

        static SurfaceStatus Status(uint blocks, bool complete, uint openFaces = 0, uint nonFinite = 0)
        {
            var counters = new uint[SurfaceCounters.Slots];
            counters[SurfaceCounters.BlocksRequested] = blocks;
            counters[SurfaceCounters.Complete] = complete ? 1u : 0u;
            counters[SurfaceCounters.OpenFaces] = openFaces;
            counters[SurfaceCounters.NonFinite] = nonFinite;
            return new SurfaceStatus(counters);
        }
    }
}
