using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Every reason that ends any run, at its border.</summary>
    public sealed class CaseFailureTests
    {
        private const int Count = 1000;
        private CaseSetup setup;
        private FluidParticle[] particles;

        [SetUp]
        public void SetUp()
        {
            setup = CaseStates.Block(1, 1);
            particles = Enumerable.Range(0, Count).Select(i => new FluidParticle(0.0004f * i * Vector3.one, Vector3.right, (uint)i))
                .ToArray();
        }

        [Test]
        public void LiquidIsNoFailure() => Assert.That(Reason(), Is.Null);

        [Test]
        public void ANumberThatIsNoneIsNamed()
        {
            particles[7].VelT0 = new Vector3(0, float.NaN, 0);
            Assert.That(Reason(), Does.Contain("particle 7"));
            particles[7] = particles[8];
            particles[5].Position.z = float.PositiveInfinity;
            Assert.That(Reason(), Does.Contain("particle 5"));
        }

        [Test]
        public void StoppedParticlesAreCounted()
        {
            Assert.That(CaseFailure.Of(new FluidCounters { DomainClamps = 5, AccelerationLimitHits = 9 }), Is.Null);
            Assert.That(CaseFailure.Of(new FluidCounters { NonFinite = 3 }), Does.StartWith("3 "));
        }

        // dx is 2 cm: half a spacing beyond the face at 0.5 m is 0.51 m; a thousandth of the particles may be there.
        [TestCase(0.5099f, 5, false)]
        [TestCase(0.5101f, 1, false)]
        [TestCase(0.5101f, 2, true)]
        [TestCase(-0.5101f, 2, true)]
        public void ParticlesBeyondWallsAreLost(float place, int count, bool fails)
        {
            for (int i = 0; i < count; i++) particles[i].Position.y = place;
            Assert.That(Reason(), fails ? Does.Contain("0.2 % of the particles are beyond a wall") : Is.Null);
        }

        [TestCase(0.009f, false)]
        [TestCase(0.011f, true)]
        public void ParticlesDeepInObstaclesAreLost(float depth, bool fails)
        {
            setup.Obstacles = new[] { CaseStates.BoxCorners(new Vector3(-0.3f, 0, 0), 0.2f * Vector3.one) };
            for (int i = 0; i < 2; i++) particles[i].Position = new Vector3(-0.2f - depth, 0.01f, 0.02f);
            Assert.That(Reason(), fails ? Does.Contain("beyond a wall") : Is.Null);
        }

        [Test]
        public void AnOpenDomainsFacesAreTheEnd()
        {
            particles[0].Position.x = particles[1].Position.x = 0.5f;
            Assert.That(Reason(), Is.Null);
            setup.IsOpen = true;
            Assert.That(Reason(), Does.Contain("which is open"));
            setup.Settings.Boundaries.Periodic = FluidAxes.X;
            Assert.That(Reason(), Is.Null, "a periodic axis has no faces");
        }

        [TestCase(0.99, true)]
        [TestCase(1.01, false)]
        public void SpeedsBeyondTheLimitFail(double limit, bool fails)
        {
            setup.SpeedLimit = limit;
            Assert.That(Reason(), fails ? Does.Contain("a particle has 1 m/s") : Is.Null);
        }

        private string Reason() => new CaseFailure(setup).Of(CaseStates.State(particles));
    }
}
