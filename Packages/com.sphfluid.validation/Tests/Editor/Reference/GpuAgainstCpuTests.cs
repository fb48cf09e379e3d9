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
    /// <summary>The GPU solver against the CPU solver in double precision, particle by particle, over many steps.</summary>
    public sealed class GpuAgainstCpuTests
    {
        private const float Spacing = 0.02f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.4f, 0.4f);

        // Largest difference of a position, over dx. Half a unit in the last place of a float position near 0.2 m is 4e-7 dx, and
        // every step adds one; density errs by 1e-6, which k = 2 c^2 turns into as much again. Neighbouring paths then part
        // exponentially, so later steps are held more loosely. llvmpipe differs by 5e-7, 5e-6 and 2e-4 dx after 1, 10 and
        // 50 steps (2026-11-21); devices that divide less exactly get five to ten times as much. A wrong term is seen at once.
        [TestCase(1, 1, 2e-6)]
        [TestCase(1, 10, 5e-6)]
        [TestCase(1, 50, 3e-5)]
        [TestCase(257, 1, 4e-6)]
        [TestCase(257, 10, 5e-5)]
        [TestCase(257, 50, 2e-3)]
        [TestCase(1009, 1, 4e-6)]
        [TestCase(1009, 10, 5e-5)]
        [TestCase(1009, 50, 2e-3)]
        public void PositionsAgree(int count, int steps, double tolerance)
        {
            Compare(count, steps, true, tolerance);
        }

        [TestCase(257, 10, 5e-5)]
        public void PositionsAgreeWithCellsOfH(int count, int steps, double tolerance)
        {
            Compare(count, steps, false, tolerance);
        }

        [TestCase(257, 10, 5e-5)]
        public void PositionsAgreeWhereMeshesHaveFriction(int count, int steps, double tolerance)
        {
            Compare(count, steps, false, tolerance, true);
        }

        private static void Compare(int count, int steps, bool octant, double tolerance, bool noSlip = false)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = octant;
            settings.Boundaries.NoSlip = noSlip;
            FluidParticle[] initial = Block(count);
            ReferenceMesh sheet = CpuScenes.Sheet();
            FluidParticle[] gpu = RunGpu(settings, initial, sheet, steps);
            using (var solver = new CpuFluidSolver(settings, initial))
            {
                CpuScenes.AddMeshes(solver, sheet);
                solver.Step(steps);
                CpuFluidParticle[] cpu = solver.Particles.ToArray().OrderBy(p => p.Id).ToArray();
                double worst = 0.0;
                double moved = 0.0;
                foreach (FluidParticle particle in gpu)
                {
                    double3 position = CpuFluidParticle.Double(particle.Position);
                    worst = Math.Max(worst, math.length(position - cpu[particle.Id].Position));
                    moved = Math.Max(moved, math.length(position - CpuFluidParticle.Double(initial[particle.Id].Position)));
                }

                TestContext.WriteLine($"{count} particles, {steps} steps: {worst / Spacing:E1} dx of {moved / Spacing:E1} dx moved");
                Assert.That(gpu.Select(p => p.Id).Distinct().Count(), Is.EqualTo(count));
                Assert.That(worst / Spacing, Is.LessThan(tolerance));
                if (steps == 1)
                {
                    Assert.That(solver.Acceleration.ToArray().Any(a => a.y > 20.0), "the triangle pushes");
                    Assert.That(gpu.Select(p => p.Id), Is.EqualTo(solver.ToFloat().Select(p => p.Id)), "order of the particles");
                }
            }
        }

        // A jittered lattice across the sheet, falling.
        private static FluidParticle[] Block(int count)
        {
            int side = (int)Math.Ceiling(Math.Pow(count, 1.0 / 3.0));
            FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(side, side, side), 0.8f * Spacing, 0.05f * Spacing, count);
            Array.Resize(ref block, count);
            for (int i = 0; i < count; i++)
            {
                block[i].Position.y += 0.108f; // 2 to 3 mm over the sheet's middle
                block[i].VelT0 = block[i].VelT1 = new Vector3(0.1f, -0.5f, 0.05f);
            }

            return block;
        }

        private static FluidParticle[] RunGpu(in FluidSolverSettings settings, FluidParticle[] initial, ReferenceMesh mesh, int steps)
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var obstacles = new FluidObstacles(settings))
                using (var solver = new FluidSolver(settings, shaders, initial))
                {
                    Vector3[] corners = mesh.Triangles.SelectMany(t => t.Select(CpuScenes.Float)).ToArray();
                    obstacles.Add(TriangleMesh.FromCorners(corners), Matrix4x4.identity);
                    obstacles.Update(Matrix4x4.identity);
                    solver.SetObstacles(obstacles);
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                    return GpuTest.Read<FluidParticle>(solver.Particles, initial.Length);
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }
    }
}
