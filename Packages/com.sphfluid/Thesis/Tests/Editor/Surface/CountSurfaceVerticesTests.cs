using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>CountSurfaceVertices against marching cubes on the CPU.</summary>
    public sealed class CountSurfaceVerticesTests
    {
        private const float Iso = 0.5f;

        // Cubes, with the ring's: less than a group of 4 along an axis, a group, one more, a prime; a field that is
        // empty, full, or noise.
        [Test]
        public void CountIsThatOfTheReference(
            [Values(1, 2, 3, 6, 15, 29)] int cells, [Values(0.0, 0.5, 1.0)] double liquidPart)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(cells, cells + 1, 2 * cells));
            var random = new System.Random(cells);
            var pass = new CountSurfaceVerticesPass(shaders);
            FluidBuffer tables = MarchingCubesTables.CreateBuffer();
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid,
                _ => random.NextDouble() < liquidPart ? 1f : 0f))
            using (GraphicsBuffer count = GpuBuffers.Create("Count", 1, sizeof(uint), GraphicsBuffer.Target.Raw))
            {
                const uint before = 5u; // what is counted is added
                count.SetData(new[] { before });
                GpuTest.Run(cmd => pass.Record(cmd, field, Iso, tables, count));
                float[] values = GpuTest.Read<float>(field.Values, grid.VertexCount);
                var reference = new MarchingCubesReference(grid, s => values[grid.Index(s.x, s.y, s.z)], Iso);
                int expected = reference.Corners(reference.FirstCube, reference.EndCube);
                Assert.AreEqual(liquidPart > 0.0, expected > 0, "closed walls make a surface of any liquid");
                Assert.AreEqual(before + (uint)expected, GpuTest.Read<uint>(count, 1)[0]);
            }
            tables.Dispose();
        }
    }
}
