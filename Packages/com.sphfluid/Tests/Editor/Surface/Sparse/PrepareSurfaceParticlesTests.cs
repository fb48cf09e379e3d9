using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// PrepareSurfaceParticles: each particle's kernel against sums over all particles in double precision.
    /// </summary>
    public sealed class PrepareSurfaceParticlesTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(1, FluidAxes.None)]
        [TestCase(255, FluidAxes.X | FluidAxes.Y)]
        [TestCase(256, FluidAxes.None)]
        [TestCase(257, FluidAxes.Z)]
        [TestCase(1009, FluidAxes.None)]
        public void SmoothKernelsLieWhereTheReferenceHasThem(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(periodic);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            Compare(count, settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize), 1e-4);
        }

        [TestCase(1)]
        [TestCase(257)]
        [TestCase(1009)]
        public void StretchedKernelsLieWhereTheReferenceHasThem(int count)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            SurfaceFieldSettings field = SurfaceFieldSettings.Anisotropic(settings, 0.75f);
            Compare(count, settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize), 1e-4);
        }

        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        public void ThesisKernelsLieAtTheParticles(int count)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, 32);
            Compare(count, settings, SurfaceFieldSettings.Thesis(settings, grid), grid, 1e-5);
        }

        [Test]
        public void WhatIsNoLiquidHasNoWeight()
        {
            const int count = 300;
            FluidSolverSettings settings = Settings(FluidAxes.None);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(count, Domain, 0f, 3)))
            {
                GpuTest.Run(rig.Solver.RecordNeighbourSetup);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, count);
                particles[0].Position.x = float.NaN;
                particles[255].Position.y = float.PositiveInfinity;
                particles[256].Position.z = float.NegativeInfinity;
                particles[299].Removed = 1f;
                rig.Solver.Particles.SetData(particles); // as the solver left them: what was set up stays
                rig.Record(field, SurfaceGrid.OverDomain(Domain, field.CellSize));
                Vector4[] prepared = GpuTest.Read<Vector4>(rig.Passes.Particles.Kernels, count);
                for (int i = 0; i < count; i++)
                {
                    bool isLiquid = i != 0 && i != 255 && i != 256 && i != 299;
                    Assert.AreEqual(isLiquid, prepared[i].w > 0f, $"particle {i} has the weight {prepared[i].w}");
                }
                Assert.AreEqual(3u, rig.Counters()[SurfaceCounters.NonFinite]);
            }
        }

        private void Compare(int count, in FluidSolverSettings settings, in SurfaceFieldSettings field, SurfaceGrid grid,
            double tolerance)
        {
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(count, Domain, 0f, count)))
            {
                rig.Record(field, grid);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, count);
                Vector4[] prepared = GpuTest.Read<Vector4>(rig.Passes.Particles.Kernels, count);
                var reference = new SurfaceFieldReference(particles, settings, field, grid);
                for (int i = 0; i < count; i++)
                {
                    Double3 centre = reference.Centre(i);
                    Vector3 found = grid.Minimum + field.SupportRadius * (Vector3)prepared[i];
                    var error = new Double3(found.x - centre.X, found.y - centre.Y, found.z - centre.Z);
                    Assert.Less(error.Length, tolerance * Spacing, $"centre of particle {i} of {count}");
                    Assert.AreEqual(1.0, prepared[i].w / reference.Weight(i), tolerance,
                        $"weight of particle {i} of {count}");
                }
            }
        }

        private static FluidSolverSettings Settings(FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = false;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }
    }
}
