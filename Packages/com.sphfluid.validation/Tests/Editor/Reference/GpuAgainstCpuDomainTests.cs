using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>What the domain does to the liquid, GPU against CPU in double precision: periodic axes, body force, moving walls.</summary>
    public sealed class GpuAgainstCpuDomainTests
    {
        public enum Feature
        {
            None,
            Periodic,
            BodyForce,
            MovingWalls,
            All,
        }

        private const float Spacing = 0.025f;
        private const int Seed = 11;

        private static readonly Vector3Int Counts = new Vector3Int(9, 8, 10);

        // Tolerances as in GpuAgainstCpuTests: a rounding of a position a step, and paths that part after many.
        [TestCase(1, 4e-6)]
        [TestCase(8, 5e-4)]
        public void PositionsAgree(int steps, double tolerance)
        {
            foreach (Feature feature in Enum.GetValues(typeof(Feature)))
            {
                foreach (bool octant in new[] { true, false })
                {
                    FluidSolverSettings settings = Settings(feature, octant);
                    Compare($"{feature}, octant {octant}", settings, steps, tolerance);
                }
            }
        }

        [Test]
        public void EveryFeatureActs()
        {
            Dictionary<uint, double3> plain = RunCpu(Settings(Feature.None, false), 50);
            foreach (Feature feature in new[] { Feature.Periodic, Feature.BodyForce, Feature.MovingWalls })
            {
                Dictionary<uint, double3> other = RunCpu(Settings(feature, false), 50);
                Assert.That(plain.Keys.Max(id => math.length(plain[id] - other[id])), Is.GreaterThan(0.02 * Spacing), feature.ToString());
            }
        }

        private static void Compare(string name, in FluidSolverSettings settings, int steps, double tolerance)
        {
            Vector3 period = settings.PeriodLength;
            Dictionary<uint, double3> cpu = RunCpu(settings, steps);
            double worst = 0.0;
            foreach (FluidParticle particle in RunGpu(settings, steps))
            {
                // On a face either side is right.
                double3 p = cpu[particle.Id];
                var image = new FluidParticle(new Vector3((float)p.x, (float)p.y, (float)p.z), Vector3.zero, 0);
                worst = Math.Max(worst, ThesisReference.Separation(particle, image, period).Length / Spacing);
            }

            TestContext.WriteLine($"{name}: {worst:E1} dx after {steps} steps");
            Assert.That(worst, Is.LessThan(tolerance), name);
        }

        // A box full of liquid in a lattice with a jitter, moving across the faces.
        private static FluidParticle[] Start()
        {
            FluidParticle[] start = ParticleSets.Lattice(Counts, Spacing, 0.05f * Spacing, Seed);
            var random = new System.Random(Seed);
            for (int i = 0; i < start.Length; i++)
            {
                start[i].VelT0 = start[i].VelT1 = new Vector3(0.6f, 0.1f, -0.4f) + 0.4f * ParticleSets.RandomVector(random);
            }

            return start;
        }

        private static FluidSolverSettings Settings(Feature feature, bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Spacing * (Vector3)Counts + new Vector3(0f, 0.4f * Spacing, 0f), Spacing);
            settings.OctantSearch = octant;
            if (feature == Feature.Periodic || feature == Feature.All) settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Z;

            if (feature == Feature.BodyForce || feature == Feature.All)
            {
                settings.BodyForce.RateSquared = new Vector3(feature == Feature.All ? 0f : 300f, 200f, 0f);
                settings.BodyForce.Centre = new Vector3(0.02f, -0.03f, 0.01f);
            }

            if (feature == Feature.MovingWalls || feature == Feature.All)
            {
                settings.Viscosity *= 5f;
                settings.Boundaries.NoSlip = true;
                settings.Boundaries.LowY = new Vector3(1.5f, 0f, 0.5f);
                settings.Boundaries.HighY = new Vector3(-1f, 0f, 0f);
                settings.Boundaries.HighX = feature == Feature.All ? Vector3.zero : new Vector3(0f, 1f, -2f);
            }

            return settings;
        }

        private static Dictionary<uint, double3> RunCpu(in FluidSolverSettings settings, int steps)
        {
            using (var solver = new CpuFluidSolver(settings, Start()))
            {
                solver.Step(steps);
                return solver.Particles.ToArray().ToDictionary(p => p.Id, p => p.Position);
            }
        }

        private static FluidParticle[] RunGpu(in FluidSolverSettings settings, int steps)
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var solver = new FluidSolver(settings, shaders, Start()))
                {
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                    return GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }
    }
}
