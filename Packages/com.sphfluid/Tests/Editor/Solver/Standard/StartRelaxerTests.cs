using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A relaxed pool does not pop when it is let go; overlapping particles part.</summary>
    public sealed class StartRelaxerTests
    {
        private const float Spacing = 0.025f, Depth = 0.15f;
        private static readonly Vector3 Domain = new Vector3(0.2f, 0.25f, 0.2f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(FluidAxes.X | FluidAxes.Z, TestName = "APoolOnAFloorDoesNotPop")]
        [TestCase(FluidAxes.None, TestName = "APoolBetweenWallsDoesNotPop")]
        public void APoolDoesNotPop(FluidAxes periodic)
        {
            FluidSolverSettings settings = Water(periodic);
            float limit = 0.1f * Mathf.Sqrt(9.81f * Spacing);
            Assert.That(Fastest(settings, Pool(0.02f)), Is.GreaterThan(limit), "without relaxation");
            FluidParticle[] rested = Relaxed(settings, Pool(0f), out bool settled);
            Assert.That(settled);
            Assert.That(Fastest(settings, rested), Is.LessThan(limit));
        }

        [Test]
        public void WithoutGravityOverlapsPart()
        {
            FluidSolverSettings settings = RelaxedStart.Settings(Water(FluidAxes.None), FluidStartRelaxation.Packed);
            FluidParticle[] start = Pool(FluidSpawner.MaxJitter);
            FluidParticle[] rested = Relaxed(settings, start, out _);
            Assert.That(rested.Select(p => p.Id), Is.EqualTo(start.Select(p => p.Id)));
            float before = Densest(settings, start), after = Densest(settings, rested);
            Assert.That(before, Is.GreaterThan(1.05f * settings.RestDensity));
            Assert.That(after, Is.LessThan(1.02f * settings.RestDensity));
        }

        private FluidParticle[] Relaxed(in FluidSolverSettings settings, FluidParticle[] start, out bool settled)
        {
            using (var relaxer = new StartRelaxer(settings, shaders, start, null, RelaxedStart.Height(settings, start)))
            {
                settled = relaxer.Run(RelaxedStart.Acceleration(settings));
                return relaxer.Read()
                    .Select(p => new FluidParticle(p.Position, Vector3.zero, p.Id) { DensityOffset = p.DensityOffset }).ToArray();
            }
        }

        private float Densest(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var solver = new FluidSolver(settings, shaders, particles))
            {
                GpuTest.Run(cmd => solver.RecordNeighbourSetup(cmd));
                return GpuTest.Read<float>(solver.Density, particles.Length).Max();
            }
        }

        private static FluidSolverSettings Water(FluidAxes periodic)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, Depth);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        private float Fastest(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var solver = new FluidSolver(settings, shaders, particles))
            {
                int steps = (int)Math.Ceiling(0.1 / settings.TimeStep);
                GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                return solver.ReadCountersNow().MaxSpeed;
            }
        }

        private static FluidParticle[] Pool(float jitter)
        {
            var box = new LiquidBox("pool",
                Matrix4x4.TRS(new Vector3(0f, 0.5f * (Depth - Domain.y), 0f), Quaternion.identity, new Vector3(Domain.x, Depth, Domain.z)),
                Vector3.zero);
            return FluidSpawner.Fill(new SpawnRequest
            {
                DomainSize = Domain, Spacing = Spacing, Shapes = new[] { box }, Jitter = jitter,
                Seed = 1
            }).Particles.ToArray();
        }
    }
}
