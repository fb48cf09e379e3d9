using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What no user means and some will do: each is contained (finite, inside, nobody lost) and named by a finding or a guard.
    /// </summary>
    public sealed class StressTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(0.8f, 0.8f, 0.7f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(shaders);

        private static FluidSolverSettings Settings() => BodyRig.Water(Domain, Spacing, 0.6f);

        private static FluidParticle[] Block(float spacing = Spacing) =>
            ParticleSets.Lattice(new Vector3Int(9, 8, 7), spacing, 0.02f * spacing, 3);

        [Test]
        public void AStepTenTimesTooLong()
        {
            FluidSolverSettings settings = Settings();
            settings.TimeStep *= 10f;
            Assert.That(Run(settings, Block(), 300), Does.Contain(FluidFailure.TimeStepTooLong));
        }

        [TestCase(2)]
        [TestCase(100)]
        public void ParticlesInOnePlace(int count)
        {
            FluidParticle[] particles = Block();
            for (int i = 1; i < count; i++) particles[i].Position = particles[0].Position;
            IReadOnlyCollection<FluidFailure> found = Run(Settings(), particles, 300);
            Assert.That(found, Does.Contain(FluidFailure.CoincidentParticles));
        }

        [Test]
        public void AShockOfHalfTheDensityMore()
        {
            const float compressed = Spacing * 0.8736f; // 1.5 to the power of -1/3
            Assert.That(Run(Settings(), Block(compressed), 300), Does.Contain(FluidFailure.OverlappingStart));
        }

        // A closed collider that appears in liquid keeps what is in it: no side is the wrong one for a particle that is on no triangle.
        [TestCase(0.1f)]
        [TestCase(0.3f)]
        public void AColliderThatAppearsInTheLiquid(float size)
        {
            using (var rig = new BodyRig(Settings()))
            {
                FluidParticle[] start = Block();
                Vector3 centre = 0.3f * Spacing * Vector3.one; // its faces cut through the lattice
                bool IsIn(FluidParticle p) =>
                    Mathf.Max(Mathf.Abs(p.Position.x - centre.x),
                        Mathf.Max(Mathf.Abs(p.Position.y - centre.y), Mathf.Abs(p.Position.z - centre.z))) < 0.5f * size;
                rig.AddBox(size * Vector3.one).localPosition = centre;
                rig.Start(start);
                rig.Frame(200);
                FluidParticle[] end = rig.Particles();
                AssertContained(end, start.Length);
                Assert.That(end.Where(IsIn).Select(p => p.Id), Is.EquivalentTo(start.Where(IsIn).Select(p => p.Id)));
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
        }

        [Test]
        public void MoreParticlesThanABufferHolds()
        {
            long most = SystemInfo.maxGraphicsBufferSize / FluidParticle.Stride;
            var error = Assert.Throws<FluidDeviceException>(() => GpuBuffers.Create("Particles", most + 1, FluidParticle.Stride).Dispose());
            Assert.That(error.Message, Does.Contain("'Particles'").And.Contain("Use fewer particles"));
        }

        [Test]
        public void MoreCellsThanNumbersOfThem()
        {
            FluidSolverSettings settings = Settings();
            settings.DomainSize = new Vector3(200f, 200f, 200f); // 5.6 billion cells
            var error = Assert.Throws<System.ArgumentException>(() => new FluidSolver(settings, shaders, Block()));
            Assert.That(error.Message, Does.Contain("cells").And.Contain("Use a smaller domain or a larger particle spacing"));
        }

        // The findings of a run, looked at before it, after a few steps and at its end.
        private IReadOnlyCollection<FluidFailure> Run(in FluidSolverSettings settings, FluidParticle[] particles, int steps)
        {
            var found = new HashSet<FluidFailure>();
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                var detectors = new FluidDetectors(settings);
                foreach (int until in new[] { 0, 20, steps })
                {
                    int now = until - (int)solver.StepCount;
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, now));
                    found.UnionWith(detectors.Update(meter.MeasureNow(), solver.ReadCountersNow()).Select(f => f.Failure));
                    AssertContained(GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount), particles.Length);
                }
            }
            return found;
        }

        private static void AssertContained(FluidParticle[] particles, int count)
        {
            Assert.That(particles.Select(p => p.Id).Distinct().Count(), Is.EqualTo(count), "nobody is lost or doubled");
            Assert.That(particles.All(p => IsFinite(p.Position) && IsFinite(p.VelT0)), "no place and no speed is without a number");
            Assert.That(particles.All(p => Mathf.Abs(p.Position.x) <= 0.5f * Domain.x && Mathf.Abs(p.Position.y) <= 0.5f * Domain.y &&
                Mathf.Abs(p.Position.z) <= 0.5f * Domain.z));
        }

        private static bool IsFinite(Vector3 v) => !float.IsNaN(v.x + v.y + v.z) && !float.IsInfinity(v.x + v.y + v.z);
    }
}
