using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What SurfaceDrawArguments leaves for the draw, whatever was in the buffer before.</summary>
    public sealed class SurfaceDrawArgumentTests
    {
        [Test]
        public void EveryArgumentIsWrittenOverWhatWasThere()
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, 16);
            using (var rig = new BlockPolygonRig(SurfaceTestScene.LoadShaders(), grid, s => 0.5f + 0.1f * (6f - (s - new Vector3(8f, 8f, 8f)).magnitude)))
            {
                rig.Mesh.DrawArguments.SetData(new uint[] { 71, 72, 73, 74, 75 });
                int indices = rig.Polygonise().Indices.Length;
                Assert.Greater(indices, 0);
                CollectionAssert.AreEqual(new uint[] { (uint)indices, 1, 0, 0, 0 }, GpuTest.Read<uint>(rig.Mesh.DrawArguments, 5),
                    "indices, instances, first index, base vertex, first instance");
            }
        }

        [TestCase(10, 20, 30, true)]
        [TestCase(11, 20, 30, false)]
        [TestCase(10, 21, 30, false)]
        [TestCase(10, 20, 31, false)]
        public void ASurfaceFitsUpToTheLastBlockVertexAndIndex(int blocks, int vertices, int indices, bool fits)
        {
            var kernel = SurfaceTestScene.LoadShaders().Kernel("SurfaceDrawArguments", "SurfaceDrawArguments");
            var counted = new uint[SurfaceCounters.Slots];
            counted[SurfaceCounters.BlocksRequested] = (uint)blocks;
            counted[SurfaceCounters.VerticesRequested] = (uint)vertices;
            counted[SurfaceCounters.IndicesRequested] = (uint)indices;
            using (GraphicsBuffer counters = GpuBuffers.Create("Counters", SurfaceCounters.Slots, sizeof(uint)))
            using (var mesh = new BlockMesh())
            {
                counters.SetData(counted);
                mesh.DrawArguments.SetData(new uint[] { 71, 72, 73, 74, 75 });
                GpuTest.Run(cmd =>
                {
                    kernel.SetInt(cmd, Shader.PropertyToID("_BlockCapacity"), 10);
                    kernel.SetInt(cmd, Shader.PropertyToID("_VertexCapacity"), 20);
                    kernel.SetInt(cmd, Shader.PropertyToID("_IndexCapacity"), 30);
                    kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, counters);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_DrawArguments"), mesh.DrawArguments);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_EmitArguments"), mesh.EmitArguments);
                    kernel.DispatchThreads(cmd, 1);
                });
                Assert.AreEqual(fits, new SurfaceStatus(GpuTest.Read<uint>(counters, SurfaceCounters.Slots)).IsComplete);
                Assert.AreEqual(fits ? 10u : 0u, GpuTest.Read<uint>(mesh.EmitArguments, 1)[0], "blocks emitted");
                Assert.AreEqual(fits ? 30u : 71u, GpuTest.Read<uint>(mesh.DrawArguments, 1)[0], "indices drawn");
            }
        }
    }
}
