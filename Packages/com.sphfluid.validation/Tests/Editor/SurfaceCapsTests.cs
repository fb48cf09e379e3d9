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
            caps.Observe(SurfaceStatuses.Of(blocks: 10, complete: false, openFaces: 2));
            caps.Observe(SurfaceStatuses.Of(blocks: 10, complete: true, nonFinite: 7));
            caps.Observe(SurfaceStatuses.Of(blocks: 0, complete: true));
            caps.Observe(SurfaceStatuses.Of(blocks: 12, complete: false));

            Assert.That(caps.StaleFrames, Is.EqualTo(2));
            Assert.That(caps.OpenFaces, Is.EqualTo(2));
            Assert.That(caps.SkippedParticles, Is.EqualTo(7));
        }
    }
}
