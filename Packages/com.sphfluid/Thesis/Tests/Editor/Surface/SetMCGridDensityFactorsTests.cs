using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>SetMCGridDensityFactors against a sum over all particles in double precision.</summary>
    public sealed class SetMCGridDensityFactorsTests
    {
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);
        private const float Spacing = 0.05f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(SurfaceGridSize.Cells32, true)]
        [TestCase(SurfaceGridSize.Cells32, false)]
        [TestCase(SurfaceGridSize.Cells32, true, false)]
        [TestCase(SurfaceGridSize.Cells32, true, true, FluidAxes.X | FluidAxes.Z)]
        [TestCase(SurfaceGridSize.Cells32, true, false, FluidAxes.X | FluidAxes.Y)]
        public void FactorsEqualTheSumOverAllParticles(SurfaceGridSize size, bool wallCompletion, bool octant = true,
            FluidAxes periodic = FluidAxes.None)
        {
            FluidParticle[] particles = ParticleSets.Random(1500, Domain, 0f, 7);
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = octant;
            settings.Boundaries.Periodic = periodic;
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var field = new SurfaceField(shaders, size.OverDomain(Domain)))
            {
                field.WallCompletion = wallCompletion;
                GpuTest.Run(cmd => field.Record(cmd, solver));
                float[] factors = GpuTest.Read<float>(field.Values, field.Grid.VertexCount);
                foreach (Vector3Int v in SomeVertices(field.Grid.Cells, 400))
                {
                    Vector3 position = field.Grid.Position(v.x, v.y, v.z);
                    double expected = Factor(particles, settings, position);
                    if (wallCompletion) expected /= InnerPart(position, settings);
                    double found = factors[field.Grid.Index(v.x, v.y, v.z)];
                    Assert.AreEqual(expected, found, 2e-4 * Math.Max(1.0, expected), $"vertex {v} at {position}");
                }
            }
        }

        // Grid vertices: fewer than a group of 8 x 8 x 4 along each axis, a group, one more, primes.
        [TestCase(1, 1, 1, 1)]
        [TestCase(6, 6, 2, 255)]
        [TestCase(7, 7, 3, 256)]
        [TestCase(8, 8, 4, 257)]
        [TestCase(12, 16, 18, 1009)]
        public void EveryVertexOfAnAwkwardGridHasItsFactor(int x, int y, int z, int count)
        {
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 0f, 7);
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, new Vector3Int(x, y, z));
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var field = new SurfaceField(shaders, grid) { WallCompletion = false })
            {
                GpuTest.Run(cmd => field.Record(cmd, solver));
                float[] factors = GpuTest.Read<float>(field.Values, grid.VertexCount);
                foreach (Vector3Int v in MarchingCubesReference.Box(Vector3Int.zero, grid.Vertices))
                {
                    double expected = Factor(particles, settings, grid.Position(v.x, v.y, v.z));
                    Assert.AreEqual(expected, factors[grid.Index(v.x, v.y, v.z)], 2e-4 * Math.Max(1.0, expected),
                        $"vertex {v}");
                }
            }
        }

        private static IEnumerable<Vector3Int> SomeVertices(Vector3Int cells, int count)
        {
            for (int corner = 0; corner < 8; corner++)
            {
                yield return new Vector3Int((corner & 1) * cells.x, (corner >> 1 & 1) * cells.y,
                    (corner >> 2) * cells.z);
            }
            var random = new System.Random(3);
            for (int i = 0; i < count; i++)
            {
                yield return new Vector3Int(random.Next(cells.x + 1), random.Next(cells.y + 1),
                    random.Next(cells.z + 1));
            }
        }

        private static double Factor(FluidParticle[] particles, FluidSolverSettings settings, Vector3 position)
        {
            double sum = 0.0;
            foreach (FluidParticle particle in particles)
            {
                Double3 d = ThesisReference.Separation(new FluidParticle(position, Vector3.zero, 0), particle,
                    settings.PeriodLength);
                sum += settings.ParticleMass * ThesisReference.Poly6(d.Length, settings.SupportRadius);
            }
            return sum / settings.RestDensity;
        }

        // The poly6 kernel's part inside the domain by summing thin slices, axis by axis.
        private static double InnerPart(Vector3 position, FluidSolverSettings settings)
        {
            double h = settings.SupportRadius;
            double part = 1.0;
            for (int axis = 0; axis < 3; axis++)
            {
                if (settings.PeriodLength[axis] > 0f) continue;
                double lower = Math.Max(-1.0, (-0.5 * Domain[axis] - position[axis]) / h);
                double upper = Math.Min(1.0, (0.5 * Domain[axis] - position[axis]) / h);
                part *= SliceSum(lower, upper) / SliceSum(-1.0, 1.0);
            }
            return part;
        }

        private static double SliceSum(double from, double to)
        {
            const int slices = 4000;
            double sum = 0.0;
            for (int i = 0; i < slices; i++)
            {
                double x = from + (to - from) * (i + 0.5) / slices;
                sum += Math.Pow(1.0 - x * x, 4) * (to - from) / slices;
            }
            return sum;
        }
    }
}
