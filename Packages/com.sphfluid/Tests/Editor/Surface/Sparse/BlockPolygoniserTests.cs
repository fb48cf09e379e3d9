using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>CountBlocks, SurfaceDrawArguments and EmitBlocks on fields that are written by hand, and against the dense twin.</summary>
    public sealed class BlockPolygoniserTests
    {
        const float Iso = 0.5f;

        FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void SphereIsClosedRoundAndFacesOutwards()
        {
            var centre = new Vector3(0.013f, -0.007f, 0.021f);
            const float radius = 0.31f;
            SurfaceMesh mesh = Polygonise(Box(Vector3.one, new Vector3Int(30, 31, 33)), p => Iso + radius - (p - centre).magnitude);
            CheckMesh(mesh, 2);
            for (int i = 0; i < mesh.VertexCount; i++)
                Assert.Greater(Vector3.Dot(mesh.Normals[i], (mesh.Positions[i] - centre).normalized), 0.98f, $"normal {i}");
            for (int i = 0; i < mesh.Indices.Length; i += 3)
                Assert.Greater(Vector3.Dot(MeshChecks.FaceNormal(mesh, i), mesh.Positions[mesh.Indices[i]] - centre), 0f, $"triangle {i / 3} faces inwards");
            Assert.AreEqual(1.0, mesh.Volume() / (4.0 / 3.0 * Math.PI * Math.Pow(radius, 3)), 0.02);
        }

        [Test]
        public void TorusHasOneHole()
        {
            SurfaceMesh mesh = Polygonise(Box(new Vector3(1f, 0.4f, 1f), new Vector3Int(40, 16, 40)), p =>
            {
                float fromRing = new Vector2(new Vector2(p.x, p.z).magnitude - 0.3f, p.y).magnitude;
                return Iso + 0.12f - fromRing;
            });
            CheckMesh(mesh, 0);
            Assert.AreEqual(1.0, mesh.Volume() / (2.0 * Math.PI * Math.PI * 0.3 * 0.12 * 0.12), 0.03);
        }

        [TestCase(0.19f, 4)]
        [TestCase(0.21f, 2)]
        public void SpheresThatTouchBecomeOne(float radius, int euler)
        {
            var centre = new Vector3(0.2f, 0f, 0f);
            SurfaceMesh mesh = Polygonise(Box(Vector3.one, new Vector3Int(40, 40, 40)), p => Iso + radius - Mathf.Min((p - centre).magnitude, (p + centre).magnitude));
            CheckMesh(mesh, euler);
        }

        [TestCase(1)]
        [TestCase(2)]
        public void NoiseIsClosed(int seed)
        {
            var random = new System.Random(seed);
            SurfaceGrid grid = Box(Vector3.one, new Vector3Int(17, 15, 22));
            float[] values = Values(grid, _ => (float)random.NextDouble());
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)]))
            {
                SurfaceMesh mesh = rig.Polygonise();
                MeshChecks.AssertClosed(mesh);
                MeshChecks.AssertSound(mesh);
                MeshChecks.AssertNoDuplicates(mesh);
                Assert.Greater(mesh.TriangleCount, 8000);
                Assert.AreEqual(0, rig.Status().OpenFaces);
            }
        }

        // Blocks without a crossing have no slot, so that gradients at the rim of the others must do without their samples.
        [TestCase(32, 32, 32)]
        [TestCase(45, 38, 23)]
        public void TrianglesAreThoseOfTheDenseTwin(int x, int y, int z)
        {
            SurfaceGrid grid = Box(Vector3.one, new Vector3Int(x, y, z));
            float Ball(Vector3 p) => Mathf.Max(0f, Iso + 0.4f - (p - new Vector3(0.15f, 0.12f, 0.3f)).magnitude);
            float[] values = Values(grid, Ball);
            using (var polygoniser = new SurfacePolygoniser(shaders))
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, Ball))
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)], block => IsCrossed(grid, values, block)))
            {
                SurfaceMesh sparse = rig.Polygonise();
                MeshChecks.AssertClosed(sparse);
                MeshChecks.AssertSameTriangles(polygoniser.Polygonise(field, Iso), sparse, 1e-6f);
                Assert.Less(rig.Status().Blocks, rig.Blocks.BlockCount);
            }
        }

        [Test]
        public void EmptyFieldGivesAnEmptyMesh()
        {
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, new Vector3Int(9, 8, 7)), _ => 0f))
            {
                Assert.AreEqual(0, rig.Polygonise().TriangleCount);
                Assert.IsTrue(rig.Status().IsComplete);
                CollectionAssert.AreEqual(new uint[] { 0, 1, 0, 0, 0 }, GpuTest.Read<uint>(rig.Mesh.DrawArguments, 5));
            }
        }

        [TestCase(5, 6, 7)]
        [TestCase(6, 14, 22)]
        [TestCase(7, 15, 8)]
        [TestCase(1, 1, 1)]
        public void FullFieldIsTheDomain(int x, int y, int z)
        {
            using (var rig = new BlockPolygonRig(shaders, Box(new Vector3(2f, 1f, 3f), new Vector3Int(x, y, z)), _ => 1f))
            {
                SurfaceMesh mesh = rig.Polygonise();
                CheckMesh(mesh, 2);
                // Each wall's face lies up to 0.02 cells inside.
                Assert.LessOrEqual(mesh.Volume(), 6.0);
                Assert.Greater(mesh.Volume(), 6.0 * (1.0 - 0.04 / x) * (1.0 - 0.04 / y) * (1.0 - 0.04 / z));
            }
        }

        [Test]
        public void OpenWallsLeaveAFullDomainWithoutASurface()
        {
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, new Vector3Int(7, 9, 14)), _ => 1f) { Walls = SurfaceWalls.Open })
                Assert.AreEqual(0, rig.Polygonise().TriangleCount);
        }

        [TestCase(7)]
        [TestCase(15)]
        [TestCase(20)]
        public void OpenSurfaceEndsExactlyOnTheWalls(int cells)
        {
            SurfaceGrid grid = Box(Vector3.one, Vector3Int.one * cells);
            float[] values = Values(grid, p => Mathf.Max(0f, Iso + 0.03f - p.y + 0.1f * Mathf.Sin(5f * p.x)));
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)]) { Walls = SurfaceWalls.Open })
            {
                SurfaceMesh mesh = rig.Polygonise();
                MeshChecks.AssertSound(mesh);
                List<(Vector3 a, Vector3 b)> rim = MeshChecks.BoundarySides(mesh);
                Assert.GreaterOrEqual(rim.Count, 4 * cells);
                foreach ((Vector3 a, Vector3 b) in rim)
                    Assert.IsTrue(OnAWall(a, b), $"the surface ends between {a} and {b}");
                Assert.AreEqual(mesh.VertexCount, rig.Status().Vertices - RepeatedVertices(rig, mesh), "vertices that no triangle uses");
            }
        }

        [TestCase(1000, 1 << 20)]
        [TestCase(1 << 20, 3000)]
        public void SurfaceThatDoesNotFitLeavesTheBuffersAlone(int vertexCapacity, int indexCapacity)
        {
            const uint canary = 0xdeadbeef;
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, Vector3Int.one * 24), s => (s - Vector3Int.one * 12).magnitude < 9f ? 1f : 0f))
            {
                rig.Mesh.Reserve(vertexCapacity, indexCapacity);
                var vertices = new uint[rig.Mesh.Vertices.count * 4];
                var indices = new uint[rig.Mesh.Indices.count];
                Array.Fill(vertices, canary);
                Array.Fill(indices, canary);
                rig.Mesh.Vertices.SetData(vertices);
                rig.Mesh.Indices.SetData(indices);
                rig.Mesh.DrawArguments.SetData(new uint[] { 42, 1, 0, 0, 0 });
                GpuTest.Run(cmd =>
                {
                    rig.RecordCount(cmd);
                    rig.RecordEmit(cmd);
                });
                SurfaceStatus status = rig.Status();
                Assert.IsFalse(status.IsComplete);
                Assert.Greater(status.Triangles, 1000);
                Assert.AreEqual(42, GpuTest.Read<uint>(rig.Mesh.DrawArguments, 1)[0], "the last surface is drawn on");
                CollectionAssert.AreEqual(vertices, GpuTest.Read<uint>(rig.Mesh.Vertices, vertices.Length));
                CollectionAssert.AreEqual(indices, GpuTest.Read<uint>(rig.Mesh.Indices, indices.Length));
            }
        }

        // 65,537 blocks are two rows of groups. Their samples would take 191 MB, more than a buffer of llvmpipe: the kernel alone is told of the capacity.
        [TestCase(0u, 0u, 0u)]
        [TestCase(1u, 1u, 1u)]
        [TestCase(65535u, 65535u, 1u)]
        [TestCase(65537u, 65535u, 2u)]
        public void GroupsContinueInASecondRow(uint blocks, uint x, uint y)
        {
            var kernel = shaders.Kernel("SurfaceDrawArguments", "SurfaceDrawArguments");
            var counted = new uint[SurfaceCounters.Slots];
            counted[SurfaceCounters.BlocksRequested] = blocks;
            using (GraphicsBuffer counters = GpuBuffers.Create("Counters", SurfaceCounters.Slots, sizeof(uint)))
            using (var mesh = new BlockMesh())
            {
                counters.SetData(counted);
                GpuTest.Run(cmd =>
                {
                    kernel.SetInt(cmd, Shader.PropertyToID("_BlockCapacity"), 70000);
                    kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, counters);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_DrawArguments"), mesh.DrawArguments);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_EmitArguments"), mesh.EmitArguments);
                    kernel.DispatchThreads(cmd, 1);
                });
                CollectionAssert.AreEqual(new[] { x, y, 1u }, GpuTest.Read<uint>(mesh.EmitArguments, 3));
            }
        }

        // Each block writes its own range and nothing beside it: what was counted is what is written.
        [Test]
        public void EmittedIsWhatWasCounted()
        {
            const uint canary = 0xdeadbeef;
            var random = new System.Random(9);
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, new Vector3Int(10, 11, 12)), _ => (float)random.NextDouble(), block => true))
            {
                var indices = new uint[rig.Mesh.Indices.count];
                Array.Fill(indices, canary);
                rig.Mesh.Indices.SetData(indices);
                rig.Polygonise();
                SurfaceStatus status = rig.Status();
                uint[] written = GpuTest.Read<uint>(rig.Mesh.Indices, indices.Length);
                for (int i = 0; i < written.Length; i++)
                {
                    if (i < 3 * status.Triangles)
                        Assert.Less(written[i], status.Vertices, $"index {i}");
                    else
                        Assert.AreEqual(canary, written[i], $"index {i}");
                }
            }
        }

        static bool OnAWall(Vector3 a, Vector3 b)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                if (a[axis] == b[axis] && Mathf.Abs(Mathf.Abs(a[axis]) - 0.5f) < 1e-7f)
                    return true;
            }
            return false;
        }

        static long RepeatedVertices(BlockPolygonRig rig, SurfaceMesh mesh)
        {
            PackedSurfaceVertex[] all = GpuTest.Read<PackedSurfaceVertex>(rig.Mesh.Vertices, (int)rig.Status().Vertices);
            var distinct = new HashSet<Vector3>();
            foreach (PackedSurfaceVertex vertex in all)
                distinct.Add(vertex.Position);
            return all.Length - distinct.Count;
        }

        static bool IsCrossed(SurfaceGrid grid, float[] values, Vector3Int block)
        {
            var samples = new float[SurfaceBlocks.SamplesPerBlock];
            for (int i = 0; i < samples.Length; i++)
            {
                Vector3Int s = BlockFieldRig.SampleAt(block, i);
                bool inGrid = s == Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(s, grid.Cells));
                samples[i] = inGrid ? values[grid.Index(s.x, s.y, s.z)] : 0f;
            }
            return BlockFieldRig.IsCrossed(block, samples, Iso, grid.Cells);
        }

        static void CheckMesh(SurfaceMesh mesh, int euler)
        {
            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            MeshChecks.AssertNoDuplicates(mesh);
            Assert.AreEqual(euler, MeshChecks.EulerCharacteristic(mesh));
        }

        static SurfaceGrid Box(Vector3 size, Vector3Int cells) => new SurfaceGrid(-0.5f * size, size, cells);

        SurfaceMesh Polygonise(SurfaceGrid grid, Func<Vector3, float> value)
        {
            using (var rig = new BlockPolygonRig(shaders, grid, s => Mathf.Max(0f, value(grid.Position(s.x, s.y, s.z)))))
                return rig.Polygonise();
        }

        static float[] Values(SurfaceGrid grid, Func<Vector3, float> value)
        {
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++)
                values[i] = value(grid.Position(i % grid.Vertices.x, i / grid.Vertices.x % grid.Vertices.y, i / (grid.Vertices.x * grid.Vertices.y)));
            return values;
        }
    }
}
