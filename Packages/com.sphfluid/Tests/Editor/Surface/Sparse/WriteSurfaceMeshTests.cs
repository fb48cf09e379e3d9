using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace SphFluid.Tests
{
    /// <summary>What the kernel writes into a mesh's buffers, against the same copy on the CPU.</summary>
    public sealed class WriteSurfaceMeshTests
    {
        private const int VertexFloats = 6;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void EveryTriangleAndVertexIsThere(
            [Values(0, 1, 85, 86, 255, 256, 257, 1009)] int triangles, [Values(0, 1, 257)] int spareTriangles, [Values] bool mirrored)
        {
            var toMesh = Matrix4x4.TRS(new Vector3(0.3f, -2f, 5f), Quaternion.Euler(20f, 130f, -60f),
                new Vector3(mirrored ? -1f : 1f, 3f, 0.5f));
            Check(triangles, spareTriangles, toMesh);
        }

        private void Check(int triangles, int spareTriangles, Matrix4x4 toMesh)
        {
            var random = new Random(triangles + spareTriangles);
            int vertexCount = Mathf.Max(1, triangles * 2 / 3);
            int indexCapacity = Mathf.Max(1, triangles + spareTriangles) * 3;
            var source = new PackedSurfaceVertex[vertexCount];
            for (int i = 0; i < vertexCount; i++)
            {
                source[i].Position = Position(random);
                source[i].PackedNormal = Half(random) | Half(random) << 16;
            }
            var indices = new uint[indexCapacity];
            for (int i = 0; i < indexCapacity; i++) indices[i] = (uint)random.Next(vertexCount);

            using (GraphicsBuffer vertexBuffer = GpuBuffers.Create("Vertices", vertexCount, PackedSurfaceVertex.Stride))
            using (GraphicsBuffer indexBuffer = GpuBuffers.Create("Indices", indexCapacity, sizeof(uint),
                GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer arguments = GpuBuffers.CreateArguments("Arguments", 5))
            using (GraphicsBuffer meshVertices = GpuBuffers.Create("MeshVertices", vertexCount + 3,
                VertexFloats * sizeof(float), GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer meshIndices = GpuBuffers.Create("MeshIndices", indexCapacity + 6, sizeof(uint),
                GraphicsBuffer.Target.Raw))
            {
                vertexBuffer.SetData(source);
                indexBuffer.SetData(indices);
                arguments.SetData(new[] { (uint)triangles * 3, 1u, 0u, 0u, 0u });
                var surface = new SurfaceBuffers(vertexBuffer, indexBuffer, arguments);
                GpuTest.Run(cmd => new WriteSurfaceMeshPass(shaders).Record(cmd, surface, meshVertices, meshIndices,
                    toMesh));

                CheckIndices(GpuTest.Read<uint>(meshIndices, meshIndices.count), indices, triangles * 3,
                    toMesh.determinant < 0f);
                if (triangles > 0) CheckVertices(GpuTest.Read<float>(meshVertices, vertexCount * VertexFloats), source, toMesh);
            }
        }

        private static void CheckIndices(uint[] written, uint[] source, int used, bool mirrored)
        {
            for (int i = 0; i < used; i += 3)
            {
                Assert.AreEqual(source[i], written[i]);
                Assert.AreEqual(source[i + 1], written[i + (mirrored ? 2 : 1)]);
                Assert.AreEqual(source[i + 2], written[i + (mirrored ? 1 : 2)]);
            }
            for (int i = used; i < written.Length; i++) Assert.AreEqual(0u, written[i], $"index {i} of the tail after {used}");
        }

        private static void CheckVertices(float[] written, PackedSurfaceVertex[] source, Matrix4x4 toMesh)
        {
            Matrix4x4 toNormal = toMesh.inverse.transpose;
            for (int i = 0; i < source.Length; i++)
            {
                int at = i * VertexFloats;
                var position = new Vector3(written[at], written[at + 1], written[at + 2]);
                var normal = new Vector3(written[at + 3], written[at + 4], written[at + 5]);
                Assert.Less((position - toMesh.MultiplyPoint3x4(source[i].Position)).magnitude, 1e-5f, $"position {i}");
                Assert.Less((normal - toNormal.MultiplyVector(source[i].Normal).normalized).magnitude, 1e-5f,
                    $"normal {i}");
                Assert.AreEqual(1f, normal.magnitude, 1e-5f);
            }
        }

        private static Vector3 Position(Random random) =>
            new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble());

        // Half of a packed normal: -32767 to 32767.
        private static uint Half(Random random) => (uint)random.Next(-32767, 32768) & 0xffffu;
    }
}
