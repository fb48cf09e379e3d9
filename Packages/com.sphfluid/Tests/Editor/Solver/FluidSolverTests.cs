using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>The steps together.</summary>
    public sealed class FluidSolverTests
    {
        private static readonly Vector3 Domain = new Vector3(0.6f, 0.5f, 0.4f);
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void SameStartGivesTheSameBits()
        {
            FluidParticle[] first = Run(TestSettings.ByRule(Domain, 0.025f), Block(), 30);
            FluidParticle[] second = Run(TestSettings.ByRule(Domain, 0.025f), Block(), 30);
            Assert.That(second.SequenceEqual(first), Is.True);
        }

        [Test]
        public void SolversThatShareShadersDoNotDisturbEachOther()
        {
            FluidSolverSettings water = TestSettings.ByRule(Domain, 0.025f);
            FluidSolverSettings syrup = TestSettings.ByRule(1.5f * Domain, 0.025f);
            syrup.Viscosity *= 4f;
            FluidParticle[] waterAlone = Run(water, Block(), 20);
            FluidParticle[] syrupAlone = Run(syrup, Block(), 20);
            using (var a = new FluidSolver(water, shaders, Block()))
            using (var b = new FluidSolver(syrup, shaders, Block()))
            {
                GpuTest.Run(cmd =>
                {
                    for (int i = 0; i < 20; i++)
                    {
                        a.RecordSteps(cmd, 1);
                        b.RecordSteps(cmd, 1);
                    }
                });
                Assert.That(GpuTest.Read<FluidParticle>(a.Particles, a.ParticleCount).SequenceEqual(waterAlone), Is.True, "first");
                Assert.That(GpuTest.Read<FluidParticle>(b.Particles, b.ParticleCount).SequenceEqual(syrupAlone), Is.True, "second");
            }
        }

        // Nothing of it is done by the GPU.
        [Test]
        public void ManyStepsAreSubmittedInPartsOfBoundedWork()
        {
            const int count = 65536, steps = 150, aPart = FluidSolver.WorkPerSubmission / count;
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 0f, 1);
            using (var solver = new FluidSolver(TestSettings.ByRule(Domain, 0.01f), shaders, particles))
            using (var cmd = new CommandBuffer())
            {
                var ends = new System.Collections.Generic.List<long>();
                solver.RecordSteps(cmd, steps, 1e-4f, () => ends.Add(solver.StepCount));
                Assert.That(ends, Is.EqualTo(new[] { aPart, 2L * aPart }));
                solver.RecordSteps(cmd, aPart, 1e-4f, () => ends.Add(solver.StepCount));
                Assert.That(ends, Has.Count.EqualTo(2), "nothing follows it");
                solver.RecordSteps(cmd, steps, 1e-4f);
                Assert.That(solver.StepCount, Is.EqualTo(2 * steps + aPart));
            }
        }

        [Test]
        public void SetupForDrawingDoesNotChangeTheMotion()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            FluidParticle[] plain = Run(settings, Block(), 10);
            using (var solver = new FluidSolver(settings, shaders, Block()))
            {
                for (int i = 0; i < 10; i++)
                {
                    GpuTest.Run(cmd =>
                    {
                        solver.RecordSteps(cmd, 1);
                        if (i < 9) solver.RecordNeighbourSetup(cmd);
                    });
                }

                Assert.That(GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount).SequenceEqual(plain), Is.True);
                Assert.That(solver.StepCount, Is.EqualTo(10));
                Assert.That(solver.SimulatedTime, Is.EqualTo(10.0 * settings.TimeStep).Within(1e-12));
            }
        }

        [Test]
        public void ScatteredParticlesFallFreely()
        {
            FluidSolverSettings settings = TestSettings.ByRule(new Vector3(2f, 2f, 2f), 0.025f);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 3, 5), 0.1f, 0f, 1);
            FluidParticle[] end = Run(settings, start, 100);
            double t = 100.0 * settings.TimeStep;
            foreach (FluidParticle p in end)
            {
                Double3 expected = (Double3)start[p.Id].Position + 0.5 * t * t * (Double3)settings.Gravity;
                Assert.That(((Double3)p.Position - expected).Length, Is.LessThan(1e-5), $"particle {p.Id}");
            }
        }

        [Test]
        public void MomentumIsKeptWithoutGravityAndWalls()
        {
            FluidSolverSettings settings = TestSettings.ByRule(2f * Vector3.one, 0.025f);
            settings.Gravity = Vector3.zero;
            FluidParticle[] start = Block();
            var random = new System.Random(3);
            for (int i = 0; i < start.Length; i++) start[i].VelT0 = 2f * ParticleSets.RandomVector(random);

            FluidParticle[] end = Run(settings, start, 80);
            Double3 before = Momentum(start, out double size);
            Double3 drift = Momentum(end, out _) - before;
            Assert.That(drift.Length, Is.LessThan(1e-5 * size));
        }

        [Test]
        public void CountersArriveByThemselves()
        {
            if (!SystemInfo.supportsAsyncGPUReadback) Assert.Ignore($"{SystemInfo.graphicsDeviceName} has no asynchronous read-back.");

            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            using (var solver = new FluidSolver(settings, shaders, Block()))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 10));
                AsyncGPUReadback.WaitAllRequests();
                float fall = 9.5f * settings.TimeStep * 9.81f;
                Assert.That(solver.Counters.MaxSpeed, Is.EqualTo(fall).Within(0.2f * fall));
                Assert.That(solver.Counters.NonFinite, Is.EqualTo(0));
                Assert.That(solver.ReadCountersNow().MaxSpeed, Is.EqualTo(solver.Counters.MaxSpeed));
            }
        }

        [Test]
        public void BlockFallsAndSettlesInsideTheDomain()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(8, 8, 8), 0.04f, 1e-4f, 2);
            using (var solver = new FluidSolver(settings, shaders, block))
            {
                int steps = (int)(0.7f / settings.TimeStep);
                for (int done = 0; done < steps; done += 100) GpuTest.Run(cmd => solver.RecordSteps(cmd, 100));

                FluidCounters counters = solver.ReadCountersNow();
                FluidParticle[] end = GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
                Assert.That(counters.NonFinite, Is.EqualTo(0));
                Assert.That(counters.AccelerationLimitHits, Is.EqualTo(0), "the limit is for emergencies");
                Assert.That(counters.DomainClamps, Is.LessThan(10), "walls hold by their force");
                Assert.That(counters.MaxCompression, Is.LessThan(0.06f));
                Assert.That(end.Average(p => p.VelT1.magnitude), Is.LessThan(0.25f), "comes to rest");
                float filled = block.Length * 0.04f * 0.04f * 0.04f / (Domain.x * Domain.z);
                float centre = end.Average(p => p.Position.y) + 0.5f * Domain.y;
                Assert.That(centre, Is.EqualTo(0.5f * filled).Within(0.2f * filled),
                    "half the depth, less what the method lacks at floor and surface");
            }
        }

        [Test]
        public void BadInputIsRefused()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            FluidParticle[] outside = { new FluidParticle(new Vector3(9f, 0f, 0f), Vector3.zero, 0) };
            Assert.Throws<ArgumentException>(() => new FluidSolver(settings, shaders, new FluidParticle[0]));
            Assert.Throws<ArgumentException>(() => new FluidSolver(settings, shaders, outside));
            Assert.Throws<ArgumentException>(() => new FluidSolver(settings, null, Block()));
            FluidSolverSettings stopped = settings;
            stopped.TimeStep = 0f;
            Assert.Throws<ArgumentException>(() => new FluidSolver(stopped, shaders, Block()));
            using (var solver = new FluidSolver(settings, shaders, Block()))
            {
                FluidSolverSettings wider = settings;
                wider.DomainSize *= 2f;
                Assert.Throws<ArgumentException>(() => solver.ApplySettings(wider));
            }
        }

        private static FluidParticle[] Block() => ParticleSets.Lattice(new Vector3Int(11, 9, 10), 0.025f, 1e-4f, 7);

        // Per unit mass.
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

        private FluidParticle[] Run(FluidSolverSettings settings, FluidParticle[] start, int steps)
        {
            using (var solver = new FluidSolver(settings, shaders, start))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                return GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
            }
        }
    }
}
