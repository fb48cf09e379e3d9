using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The density factors of moving and resting liquids, and the surface in them.</summary>
    public sealed class SurfaceFieldTests
    {
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);
        private const float Spacing = 0.05f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void FieldFollowsTheParticlesAndForgetsWhereTheyWere()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            SurfaceGrid grid = SurfaceGridSize.Cells32.OverDomain(Domain);
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

        // Liquid at rest fills the lower half of the domain from wall to wall; its surface is flat, and as high at the
        // walls as amid.
        [Test]
        public void SurfaceOfLiquidAtRestEndsLevelAtTheWalls()
        {
            var domain = new Vector3(1f, 1f, 1f);
            FluidSolverSettings settings = TestSettings.ByRule(domain, Spacing);
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(20, 10, 20), Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position.y -= 0.25f;
            using (var solver = new FluidSolver(settings, shaders, particles))
            {
                SurfaceMesh mesh = ThesisSurfaceMesher.Extract(solver, shaders, SurfaceGridSize.Cells64);
                MeshChecks.AssertClosed(mesh);
                MeshChecks.AssertSound(mesh);
                Assert.AreEqual(0.5, mesh.Volume(), 0.03);
                for (int i = 0; i < mesh.VertexCount; i++)
                {
                    if (mesh.Normals[i].y > 0.9f) Assert.AreEqual(0f, mesh.Positions[i].y, 0.6f * Spacing, $"{mesh.Positions[i]}");
                }
            }
        }
    }
}
