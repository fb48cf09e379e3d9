using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ResetMCGrid and SetMCGridDensityFactors against a sum over all particles in double precision.</summary>
    public sealed class SurfaceFieldTests
    {
        static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);
        const float Spacing = 0.05f;

        FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(SurfaceGridSize.Cells32, true)]
        [TestCase(SurfaceGridSize.Cells32, false)]
        [TestCase(SurfaceGridSize.Cells64, true)]
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
            using (var field = new SurfaceField(shaders, SurfaceGrid.OverDomain(Domain, size)) { WallCompletion = wallCompletion })
            {
                GpuTest.Run(cmd => field.Record(cmd, solver));
                float[] factors = GpuTest.Read<float>(field.Values, field.Grid.VertexCount);
                foreach (Vector3Int v in SomeVertices(field.Grid.Cells, 400))
                {
                    Vector3 position = field.Grid.Position(v.x, v.y, v.z);
                    double expected = Factor(particles, settings, position);
                    if (wallCompletion)
                        expected /= InnerPart(position, settings);
                    double found = factors[field.Grid.Index(v.x, v.y, v.z)];
                    Assert.AreEqual(expected, found, 2e-4 * Math.Max(1.0, expected), $"vertex {v} at {position}");
                }
            }
        }

        [Test]
        public void ResetEmptiesTheWholeGrid()
        {
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, SurfaceGridSize.Cells32);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, _ => 7f))
            {
                GpuTest.Run(cmd => new ResetMCGridPass(shaders).Record(cmd, field));
                CollectionAssert.AreEqual(new float[grid.VertexCount], GpuTest.Read<float>(field.Values, grid.VertexCount));
            }
        }

        [Test]
        public void FieldFollowsTheParticlesAndForgetsWhereTheyWere()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, SurfaceGridSize.Cells32);
            using (var field = new SurfaceField(shaders, grid))
            {
                foreach (float x in new[] { -0.3f, 0.3f })
                {
                    var one = new[] { new FluidParticle(new Vector3(x, 0f, 0f), Vector3.zero, 0) };
                    using (var solver = new FluidSolver(settings, shaders, one))
                        GpuTest.Run(cmd => field.Record(cmd, solver));
                    float[] factors = GpuTest.Read<float>(field.Values, grid.VertexCount);
                    for (int i = 0; i < factors.Length; i++)
                    {
                        Vector3Int sides = grid.Vertices;
                        Vector3 position = grid.Position(i % sides.x, i / sides.x % sides.y, i / (sides.x * sides.y));
                        if ((position - one[0].Position).magnitude > 1.0001f * settings.SupportRadius)
                            Assert.AreEqual(0f, factors[i], $"{position} is out of reach");
                        else if ((position - one[0].Position).magnitude < 0.99f * settings.SupportRadius)
                            Assert.Greater(factors[i], 0f, $"{position} is in reach");
                    }
                }
            }
        }

        // Liquid at rest fills the lower half of the domain from wall to wall; its surface is flat, and as high at the walls as amid.
        [Test]
        public void SurfaceOfLiquidAtRestMeetsTheWallsLevel()
        {
            var domain = new Vector3(1f, 1f, 1f);
            FluidSolverSettings settings = TestSettings.ByRule(domain, Spacing);
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(20, 10, 20), Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++)
                particles[i].Position.y -= 0.25f;
            using (var solver = new FluidSolver(settings, shaders, particles))
            {
                SurfaceMesh mesh = FluidSurfaceMesher.Extract(solver, shaders, SurfaceGridSize.Cells64);
                MeshChecks.AssertClosed(mesh);
                MeshChecks.AssertSound(mesh);
                Assert.AreEqual(0.5, mesh.Volume(), 0.03);
                for (int i = 0; i < mesh.VertexCount; i++)
                {
                    if (mesh.Normals[i].y > 0.9f)
                        Assert.AreEqual(0f, mesh.Positions[i].y, 0.6f * Spacing, $"{mesh.Positions[i]}");
                }
            }
        }

        static IEnumerable<Vector3Int> SomeVertices(Vector3Int cells, int count)
        {
            for (int corner = 0; corner < 8; corner++)
                yield return new Vector3Int((corner & 1) * cells.x, (corner >> 1 & 1) * cells.y, (corner >> 2) * cells.z);
            var random = new System.Random(3);
            for (int i = 0; i < count; i++)
                yield return new Vector3Int(random.Next(cells.x + 1), random.Next(cells.y + 1), random.Next(cells.z + 1));
        }

        static double Factor(FluidParticle[] particles, FluidSolverSettings settings, Vector3 position)
        {
            double sum = 0.0;
            foreach (FluidParticle particle in particles)
            {
                Double3 d = ThesisReference.Separation(new FluidParticle(position, Vector3.zero, 0), particle, settings.PeriodLength);
                sum += settings.ParticleMass * ThesisReference.Poly6(d.Length, settings.SupportRadius);
            }
            return sum / settings.RestDensity;
        }

        // The poly6 kernel's part inside the domain by summing thin slices, axis by axis.
        static double InnerPart(Vector3 position, FluidSolverSettings settings)
        {
            double h = settings.SupportRadius;
            double part = 1.0;
            for (int axis = 0; axis < 3; axis++)
            {
                if (settings.PeriodLength[axis] > 0f)
                    continue;
                double lower = Math.Max(-1.0, (-0.5 * Domain[axis] - position[axis]) / h);
                double upper = Math.Min(1.0, (0.5 * Domain[axis] - position[axis]) / h);
                part *= SliceSum(lower, upper) / SliceSum(-1.0, 1.0);
            }
            return part;
        }

        static double SliceSum(double from, double to)
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
