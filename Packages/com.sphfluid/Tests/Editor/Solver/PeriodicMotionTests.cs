using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles that cross the faces of periodic axes.</summary>
    public sealed class PeriodicMotionTests
    {
        private const float Spacing = 0.025f;

        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => Object.DestroyImmediate(shaders);

        // The corner crosses three faces in one step; 3.2 m is three boxes and a fifth.
        [TestCase(0.499f, 0f, 0f, 2f, 0f, 0f)]
        [TestCase(0f, -0.499f, 0.1f, 0.5f, -3f, 0f)]
        [TestCase(-0.5f, 0.5f, -0.499f, -1f, 2f, -3f)]
        [TestCase(0.3f, 0.2f, 0.1f, 3200f, 0f, 0f)]
        public void AParticleComesInAtTheOtherFaceWithItsVelocity(float x, float y, float z, float u, float v, float w)
        {
            FluidSolverSettings settings = Settings(Vector3.one, FluidAxes.All);
            settings.TimeStep = 1e-3f;
            var start = new FluidParticle(new Vector3(x, y, z), new Vector3(u, v, w), 0);
            FluidParticle end = Run(settings, new[] { start }, 1, out FluidCounters counters)[0];
            Double3 expected = (Double3)start.Position + settings.TimeStep * (Double3)start.VelT0;
            for (int axis = 0; axis < 3; axis++)
            {
                float place = end.Position[axis];
                double displacement = new[] { expected.X, expected.Y, expected.Z }[axis] - place;
                Assert.That(Mathf.Abs(place), Is.LessThanOrEqualTo(0.5f), "inside");
                Assert.That(displacement - System.Math.Round(displacement), Is.EqualTo(0.0).Within(5e-7), $"whole boxes along axis {axis}");
            }

            Assert.That(end.VelT0, Is.EqualTo(start.VelT0));
            Assert.That(counters.DomainClamps, Is.Zero, "a face that is none holds nothing");
        }

        [Test]
        public void AxesWithWallsKeepThem()
        {
            FluidSolverSettings settings = Settings(Vector3.one, FluidAxes.X);
            settings.TimeStep = 1e-3f;
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallStiffness = own.WallDamping = 0f);
            var start = new FluidParticle(new Vector3(0.4999f, 0.4999f, 0f), new Vector3(2f, 2f, 0f), 0);
            FluidParticle end = Run(settings, new[] { start }, 1, out FluidCounters counters)[0];
            Assert.That(end.Position.x, Is.EqualTo(-0.4981f).Within(1e-6f));
            Assert.That(end.Position.y, Is.EqualTo(0.5f));
            Assert.That(end.VelT0, Is.EqualTo(new Vector3(2f, 0f, 0f)));
            Assert.That(counters.DomainClamps, Is.EqualTo(1));
        }

        [Test]
        public void FacesOfPeriodicAxesDoNotPush()
        {
            FluidSolverSettings settings = Settings(Vector3.one, FluidAxes.X | FluidAxes.Z);
            FluidParticle[] resting =
            {
                new FluidParticle(new Vector3(0.4999f, 0f, 0f), Vector3.zero, 0),
                new FluidParticle(new Vector3(0f, 0.1f, -0.4999f), Vector3.zero, 1),
                new FluidParticle(new Vector3(0f, -0.4999f, 0.2f), Vector3.zero, 2),
            };
            Dictionary<uint, FluidParticle> end = Run(settings, resting, 1, out _).ToDictionary(p => p.Id);
            Assert.That(end[0].VelT0, Is.EqualTo(Vector3.zero));
            Assert.That(end[1].VelT0, Is.EqualTo(Vector3.zero));
            Assert.That(end[2].VelT0.y, Is.GreaterThan(0f), "the floor does");
        }

        [Test]
        public void MomentumOfAPeriodicBoxIsKept([Values] bool octant)
        {
            var counts = new Vector3Int(8, 9, 10);
            FluidSolverSettings settings = Settings(Spacing * (Vector3)counts, FluidAxes.All);
            settings.OctantSearch = octant;
            FluidParticle[] start = ParticleSets.Lattice(counts, Spacing, 0.1f * Spacing, 3);
            var random = new System.Random(3);
            for (int i = 0; i < start.Length; i++) start[i].VelT0 = new Vector3(0.7f, -0.3f, 0.2f) + ParticleSets.RandomVector(random);

            FluidParticle[] end = Run(settings, start, 40, out FluidCounters counters);
            Double3 before = Momentum(start, out double size);
            Double3 drift = Momentum(end, out _) - before;
            TestContext.WriteLine($"drift {drift.Length / size:E1}");
            Assert.That(drift.Length, Is.LessThan(1e-6 * size)); // 1e-5 in 1,000 steps is asked
            Assert.That(counters.AccelerationLimitHits + counters.DomainClamps + counters.NonFinite, Is.Zero);
            int crossed = end.Count(p => Vector3.Distance(p.Position, start[p.Id].Position) > 0.5f * settings.DomainSize.x);
            TestContext.WriteLine($"{crossed} crossed");
            Assert.That(crossed, Is.GreaterThan(20), "particles crossed the faces");
        }

        // Galilean invariance: the box carried along by whole boxes ends as the box at rest.
        [Test]
        public void AFlowThroughTheFacesIsTheSameAsRest()
        {
            var counts = new Vector3Int(8, 8, 8);
            FluidSolverSettings settings = Settings(Spacing * (Vector3)counts, FluidAxes.All);
            settings.OctantSearch = false;
            FluidParticle[] rest = ParticleSets.Lattice(counts, Spacing, 0.1f * Spacing, 5);
            float speed = settings.DomainSize.x / (40f * settings.TimeStep);
            FluidParticle[] moving = rest.Select(p => new FluidParticle(p.Position, new Vector3(speed, 0f, 0f), p.Id)).ToArray();
            Dictionary<uint, FluidParticle> still = Run(settings, rest, 40, out _).ToDictionary(p => p.Id);
            foreach (FluidParticle p in Run(settings, moving, 40, out _))
            {
                Double3 apart = ThesisReference.Separation(p, still[p.Id], settings.PeriodLength);
                Assert.That(apart.Length, Is.LessThan(1e-3 * Spacing), $"particle {p.Id}");
            }
        }

        private static FluidSolverSettings Settings(Vector3 domain, FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(domain, Spacing);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        private static Double3 Momentum(FluidParticle[] particles, out double size)
        {
            Double3 sum = Double3.Zero;
            size = 0.0;
            foreach (FluidParticle p in particles)
            {
                sum += p.VelT0;
                size += p.VelT0.magnitude;
            }

            return sum;
        }

        private FluidParticle[] Run(in FluidSolverSettings settings, FluidParticle[] start, int steps, out FluidCounters counters)
        {
            using (var solver = new FluidSolver(settings, shaders, start))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                counters = solver.ReadCountersNow();
                return GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
            }
        }
    }
}
