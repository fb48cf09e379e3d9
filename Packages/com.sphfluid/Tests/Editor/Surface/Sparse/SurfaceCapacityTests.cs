using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The first buffers of a surface, before anything was measured.</summary>
    public sealed class SurfaceCapacityTests
    {
        // A cube of n particles has 6 n^(2/3) dx² of surface; at one block for 64 dx² and as many again beside them.
        [TestCase(64_000)]
        [TestCase(512_000)]
        public void TheFirstBuffersHoldTheSurfaceOfACubeOfAllParticles(int particles)
        {
            const float spacing = 0.01f;
            float side = spacing * Mathf.Pow(particles, 1f / 3f);
            Vector3 domain = 2f * side * Vector3.one;
            FluidSolverSettings settings = TestSettings.ByRule(domain, spacing);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(domain, field.CellSize);
            float block = SurfaceBlocks.CubesPerSide * field.CellSize;
            int blocks = Mathf.CeilToInt(6f * side * side / (block * block));
            GpuTest.Require();
            using (var triangles = new SurfaceTriangles())
            using (var made = new SurfaceBlocks())
            {
                new SurfaceCapacity(0, 0).Reserve(made, triangles, grid, field, particles, default);
                Assert.That(made.Capacity, Is.GreaterThanOrEqualTo(blocks), "blocks");
                float expected = 2f * 6f * side * side / (field.CellSize * field.CellSize);
                Assert.That(triangles.IndexCapacity / 3f, Is.GreaterThanOrEqualTo(expected), "two triangles a cube");
            }
        }
    }
}
