using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The dense polygoniser at the very edge of its buffer.</summary>
    public sealed class SurfaceCapacityTests
    {
        [Test]
        public void ASurfaceThatFillsTheBufferToTheLastCornerIsWhole()
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, 16);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, p => 0.8f - p.magnitude))
            using (var roomy = new SurfacePolygoniser(shaders))
            {
                SurfaceMesh expected = roomy.Polygonise(field);
                using (var exact = new SurfacePolygoniser(shaders, expected.Indices.Length))
                {
                    SurfaceMesh mesh = exact.Polygonise(field);
                    Assert.AreEqual(expected.Indices.Length, exact.VertexCapacity);
                    CollectionAssert.AreEqual(expected.Positions, mesh.Positions);
                    CollectionAssert.AreEqual(expected.Indices, mesh.Indices);
                }
                using (var small = new SurfacePolygoniser(shaders, expected.Indices.Length - 1))
                {
                    Assert.Throws<FluidDeviceException>(() => small.Polygonise(field), "one corner too few");
                }
            }
        }

        [Test]
        public void NothingIsWrittenBehindTheCapacity()
        {
            const int capacity = 100, held = 400;
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, 16);
            var kernel = shaders.Kernel("SurfaceMesh", "EmitSurfaceVertices");
            var untouched = new float[held * EmittedVertex.Stride / sizeof(float)];
            System.Array.Fill(untouched, -7f);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, p => 0.8f - p.magnitude))
            using (GraphicsBuffer tables = SurfacePolygoniser.CreateTables())
            using (GraphicsBuffer count = GpuBuffers.Create("Count", 1, sizeof(uint), GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer vertices = GpuBuffers.Create("Vertices", held, EmittedVertex.Stride))
            {
                vertices.SetData(untouched);
                count.SetData(new uint[1]);
                GpuTest.Run(cmd =>
                {
                    kernel.SetBuffer(cmd, SurfaceShaderIds.MCGrid, field.Values);
                    kernel.SetBuffer(cmd, SurfaceShaderIds.MCTables, tables);
                    kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertexCount, count);
                    kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertices, vertices);
                    kernel.SetInt(cmd, SurfaceShaderIds.SurfaceVertexCapacity, capacity);
                    kernel.SetGrid(cmd, grid);
                    kernel.SetIsoValue(cmd, 0.5f);
                    Vector3Int cubes = grid.Cubes;
                    kernel.DispatchThreads(cmd, cubes.x, cubes.y, cubes.z);
                });
                Assert.Greater(GpuTest.Read<uint>(count, 1)[0], held, "the surface is larger than the buffer");
                var read = new float[untouched.Length];
                vertices.GetData(read);
                int first = capacity * EmittedVertex.Stride / sizeof(float);
                Assert.That(System.Array.FindIndex(read, first, value => value != -7f), Is.EqualTo(-1));
                Assert.That(read[0], Is.Not.EqualTo(-7f), "what fits is written");
            }
        }
    }
}
