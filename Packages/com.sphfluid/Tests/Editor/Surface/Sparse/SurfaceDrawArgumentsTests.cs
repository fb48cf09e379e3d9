using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// SurfaceDrawArguments: what fits is emitted and drawn, whatever was in the buffers before; what does not leaves
    /// them alone.
    /// </summary>
    public sealed class SurfaceDrawArgumentsTests
    {
        [Test]
        public void EveryArgumentIsWrittenOverWhatWasThere()
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, 16);
            using (var rig = new BlockPolygonRig(SurfaceTestScene.LoadShaders(), grid,
                s => 0.5f + 0.1f * (6f - (s - new Vector3(8f, 8f, 8f)).magnitude)))
            {
                rig.Triangles.DrawArguments.SetData(new uint[] { 71, 72, 73, 74, 75 });
                int indices = rig.Polygonise().Indices.Length;
                Assert.Greater(indices, 0);
                CollectionAssert.AreEqual(new uint[] { (uint)indices, 1, 0, 0, 0 },
                    GpuTest.Read<uint>(rig.Triangles.DrawArguments, 5),
                    "indices, instances, first index, base vertex, first instance");
            }
        }

        [TestCase(10, 20, 30, true)]
        [TestCase(11, 20, 30, false)]
        [TestCase(10, 21, 30, false)]
        [TestCase(10, 20, 31, false)]
        public void ASurfaceFitsUpToTheLastBlockVertexAndIndex(int blocks, int vertices, int indices, bool fits)
        {
            using (var triangles = new SurfaceTriangles())
            {
                triangles.DrawArguments.SetData(new uint[] { 71, 72, 73, 74, 75 });
                SurfaceStatus status = Decide(triangles, 10, (uint)blocks, (uint)vertices, (uint)indices);
                Assert.AreEqual(fits, status.IsComplete);
                Assert.AreEqual(fits ? 10u : 0u, GpuTest.Read<uint>(triangles.EmitArguments, 1)[0], "blocks emitted");
                Assert.AreEqual(fits ? 30u : 71u, GpuTest.Read<uint>(triangles.DrawArguments, 1)[0], "indices drawn");
            }
        }

        // 65,537 blocks are two rows of groups. Their samples would take 191 MB, more than a buffer of llvmpipe: only
        // the kernel gets the capacity.
        [TestCase(0u, 0u, 0u)]
        [TestCase(1u, 1u, 1u)]
        [TestCase(65535u, 65535u, 1u)]
        [TestCase(65537u, 65535u, 2u)]
        public void GroupsContinueInASecondRow(uint blocks, uint x, uint y)
        {
            using (var triangles = new SurfaceTriangles())
            {
                Decide(triangles, 70000, blocks, 0, 0);
                CollectionAssert.AreEqual(new[] { x, y, 1u }, GpuTest.Read<uint>(triangles.EmitArguments, 3));
            }
        }

        [TestCase(1000, 1 << 20)]
        [TestCase(1 << 20, 3000)]
        public void SurfaceThatDoesNotFitLeavesTheBuffersAlone(int vertexCapacity, int indexCapacity)
        {
            const uint canary = 0xdeadbeef;
            using (var rig = new BlockPolygonRig(SurfaceTestScene.LoadShaders(),
                new SurfaceGrid(Vector3.zero, Vector3.one, 24),
                s => (s - Vector3Int.one * 12).magnitude < 9f ? 1f : 0f))
            {
                rig.Triangles.Reserve(vertexCapacity, indexCapacity);
                var vertices = new uint[rig.Triangles.Vertices.Count * 4];
                var indices = new uint[rig.Triangles.Indices.Count];
                Array.Fill(vertices, canary);
                Array.Fill(indices, canary);
                rig.Triangles.Vertices.SetData(vertices);
                rig.Triangles.Indices.SetData(indices);
                rig.Triangles.DrawArguments.SetData(new uint[] { 42, 1, 0, 0, 0 });
                GpuTest.Run(cmd =>
                {
                    rig.RecordCount(cmd);
                    rig.RecordEmit(cmd);
                });
                SurfaceStatus status = rig.Status();
                Assert.IsFalse(status.IsComplete);
                Assert.Greater(status.Triangles, 1000);
                Assert.AreEqual(42, GpuTest.Read<uint>(rig.Triangles.DrawArguments, 1)[0],
                    "the last surface is drawn on");
                CollectionAssert.AreEqual(vertices, GpuTest.Read<uint>(rig.Triangles.Vertices, vertices.Length));
                CollectionAssert.AreEqual(indices, GpuTest.Read<uint>(rig.Triangles.Indices, indices.Length));
            }
        }

        // What the kernel makes of counters, where 20 vertices and 30 indices fit.
        private static SurfaceStatus Decide(SurfaceTriangles triangles, int blockCapacity, uint blocks, uint vertices,
            uint indices)
        {
            var counted = new uint[SurfaceCounters.Slots];
            counted[SurfaceCounters.BlocksRequested] = blocks;
            counted[SurfaceCounters.VerticesRequested] = vertices;
            counted[SurfaceCounters.IndicesRequested] = indices;
            var pass = new SurfaceDrawArgumentsPass(SurfaceTestScene.LoadShaders());
            using (var one = new SurfaceBlocks())
            {
                one.Reserve(Vector3Int.one, 1);
                one.Counters.SetData(counted);
                GpuTest.Run(cmd => pass.Record(cmd, one.Counters, blockCapacity, 20, 30, triangles));
                return new SurfaceStatus(GpuTest.Read<uint>(one.Counters, SurfaceCounters.Slots));
            }
        }
    }
}
