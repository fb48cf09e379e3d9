using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>EmitSurfaceVertices against marching cubes on the CPU, and at the very edge of its buffer.</summary>
    public sealed class EmitSurfaceVerticesTests
    {
        private const float Iso = 0.5f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        // Cubes, with the ring's: less than a group of 4 along an axis, a group, one more, a prime.
        [TestCase(1, 1, 1)]
        [TestCase(1, 2, 3)]
        [TestCase(6, 7, 5)]
        [TestCase(15, 17, 29)]
        public void TrianglesAreThoseOfTheReference(int x, int y, int z)
        {
            var grid = new SurfaceGrid(new Vector3(-1f, 2f, 0.5f), new Vector3(x, y, z), new Vector3Int(x, y, z));
            var random = new System.Random(x);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, _ => (float)random.NextDouble()))
            using (var polygoniser = new SurfacePolygoniser(shaders))
            {
                float[] values = GpuTest.Read<float>(field.Values, grid.VertexCount);
                var reference = new MarchingCubesReference(grid, s => values[grid.Index(s.x, s.y, s.z)], Iso);
                MeshChecks.AssertSameTriangles(reference.Mesh(), polygoniser.Polygonise(field, Iso), 1e-4f);
            }
        }

        [Test]
        public void NothingIsWrittenBeyondTheCapacity()
        {
            const int capacity = 100, held = 400;
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, 16);
            var pass = new EmitSurfaceVerticesPass(shaders);
            var untouched = new float[held * EmittedVertex.Stride / sizeof(float)];
            Array.Fill(untouched, -7f);
            FluidBuffer tables = MarchingCubesTables.CreateBuffer();
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, p => 0.8f - p.magnitude))
            using (GraphicsBuffer count = GpuBuffers.Create("Count", 1, sizeof(uint), GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer vertices = GpuBuffers.Create("Vertices", held, EmittedVertex.Stride))
            {
                vertices.SetData(untouched);
                count.SetData(new uint[1]);
                GpuTest.Run(cmd => pass.Record(cmd, field, Iso, tables, count, vertices, capacity));
                Assert.Greater(GpuTest.Read<uint>(count, 1)[0], held, "the surface is larger than the buffer");
                var read = new float[untouched.Length];
                vertices.GetData(read);
                int first = capacity * EmittedVertex.Stride / sizeof(float);
                Assert.That(Array.FindIndex(read, first, value => value != -7f), Is.EqualTo(-1));
                Assert.That(read[0], Is.Not.EqualTo(-7f), "what fits is written");
            }
            tables.Dispose();
        }
    }
}
