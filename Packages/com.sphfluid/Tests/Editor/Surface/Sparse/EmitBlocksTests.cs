using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// EmitBlocks on fields that are written by hand, against marching cubes on the CPU and against the dense twin.
    /// </summary>
    public sealed class EmitBlocksTests
    {
        private const float Iso = 0.5f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void SphereIsClosedRoundAndFacesOutwards()
        {
            var centre = new Vector3(0.013f, -0.007f, 0.021f);
            const float radius = 0.31f;
            SurfaceMesh mesh = Polygonise(Box(Vector3.one, new Vector3Int(30, 31, 33)),
                p => Iso + radius - (p - centre).magnitude);
            CheckMesh(mesh, 2);
            for (int i = 0; i < mesh.VertexCount; i++)
            {
                Assert.Greater(Vector3.Dot(mesh.Normals[i], (mesh.Positions[i] - centre).normalized), 0.98f,
                    $"normal {i}");
            }
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                Assert.Greater(Vector3.Dot(MeshChecks.FaceNormal(mesh, i), mesh.Positions[mesh.Indices[i]] - centre),
                    0f, $"triangle {i / 3} faces inwards");
            }
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
            SurfaceMesh mesh = Polygonise(Box(Vector3.one, new Vector3Int(40, 40, 40)),
                p => Iso + radius - Mathf.Min((p - centre).magnitude, (p + centre).magnitude));
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

        // 1, 2, 7 and 30 blocks; cells that fill the last block, leave one cube in it, or leave none to spare.
        [TestCase(1, 1, 1)]
        [TestCase(6, 6, 6)]
        [TestCase(7, 6, 5)]
        [TestCase(54, 6, 6)]
        [TestCase(13, 12, 31)]
        public void TrianglesAreThoseOfTheReference(int x, int y, int z)
        {
            SurfaceGrid grid = Box(new Vector3(x, y, z), new Vector3Int(x, y, z));
            var random = new System.Random(x);
            float[] values = Values(grid, _ => (float)random.NextDouble());
            float Value(Vector3Int s) => values[grid.Index(s.x, s.y, s.z)];
            foreach (SurfaceWalls walls in new[] { SurfaceWalls.Closed, SurfaceWalls.Open })
            {
                using (var rig = new BlockPolygonRig(shaders, grid, Value, walls: walls))
                    MeshChecks.AssertSameTriangles(new MarchingCubesReference(grid, Value, Iso, walls).Mesh(),
                        rig.Polygonise(), 1e-4f);
            }
        }

        // Blocks without a crossing have no slot, so that gradients at the rim of the others must do without their
        // samples.
        [TestCase(32, 32, 32)]
        [TestCase(45, 38, 23)]
        public void TrianglesAreThoseOfTheDenseTwin(int x, int y, int z)
        {
            SurfaceGrid grid = Box(Vector3.one, new Vector3Int(x, y, z));
            float Ball(Vector3 p) => Mathf.Max(0f, Iso + 0.4f - (p - new Vector3(0.15f, 0.12f, 0.3f)).magnitude);
            float[] values = Values(grid, Ball);
            using (var polygoniser = new SurfacePolygoniser(shaders))
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, Ball))
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)],
                block => IsCrossed(grid, values, block)))
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
                CollectionAssert.AreEqual(new uint[] { 0, 1, 0, 0, 0 },
                    GpuTest.Read<uint>(rig.Triangles.DrawArguments, 5));
            }
        }

        [TestCase(5, 6, 7)]
        [TestCase(6, 14, 22)]
        [TestCase(7, 15, 8)]
        [TestCase(1, 1, 1)]
        public void FullFieldIsTheDomain(int x, int y, int z)
        {
            using (var rig = new BlockPolygonRig(shaders, Box(new Vector3(2f, 1f, 3f), new Vector3Int(x, y, z)),
                _ => 1f))
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
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, new Vector3Int(7, 9, 14)),
                _ => 1f, walls: SurfaceWalls.Open))
                Assert.AreEqual(0, rig.Polygonise().TriangleCount);
        }

        [TestCase(7)]
        [TestCase(15)]
        [TestCase(20)]
        public void OpenSurfaceEndsExactlyOnTheWalls(int cells)
        {
            SurfaceGrid grid = Box(Vector3.one, Vector3Int.one * cells);
            float[] values = Values(grid, p => Mathf.Max(0f, Iso + 0.03f - p.y + 0.1f * Mathf.Sin(5f * p.x)));
            using (var rig = new BlockPolygonRig(shaders, grid,
                s => values[grid.Index(s.x, s.y, s.z)], walls: SurfaceWalls.Open))
            {
                SurfaceMesh mesh = rig.Polygonise();
                MeshChecks.AssertSound(mesh);
                List<(Vector3 a, Vector3 b)> rim = MeshChecks.BoundarySides(mesh);
                Assert.GreaterOrEqual(rim.Count, 4 * cells);
                foreach ((Vector3 a, Vector3 b) in rim) Assert.IsTrue(OnAWall(a, b), $"the surface ends between {a} and {b}");
                Assert.AreEqual(mesh.VertexCount, rig.Status().Vertices - RepeatedVertices(rig, mesh),
                    "vertices that no triangle uses");
            }
        }

        // Each block writes its own range and nothing beside it: what was counted is what is written.
        [Test]
        public void EmittedIsWhatWasCounted()
        {
            const uint canary = 0xdeadbeef;
            var random = new System.Random(9);
            using (var rig = new BlockPolygonRig(shaders, Box(Vector3.one, new Vector3Int(10, 11, 12)),
                _ => (float)random.NextDouble(), block => true))
            {
                var indices = new uint[rig.Triangles.Indices.Count];
                Array.Fill(indices, canary);
                rig.Triangles.Indices.SetData(indices);
                rig.Polygonise();
                SurfaceStatus status = rig.Status();
                uint[] written = GpuTest.Read<uint>(rig.Triangles.Indices, indices.Length);
                for (int i = 0; i < written.Length; i++)
                {
                    if (i < 3 * status.Triangles)
                        Assert.Less(written[i], status.Vertices, $"index {i}");
                    else
                        Assert.AreEqual(canary, written[i], $"index {i}");
                }
            }
        }

        private static bool OnAWall(Vector3 a, Vector3 b)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                if (a[axis] == b[axis] && Mathf.Abs(Mathf.Abs(a[axis]) - 0.5f) < 1e-7f) return true;
            }
            return false;
        }

        private static long RepeatedVertices(BlockPolygonRig rig, SurfaceMesh mesh)
        {
            PackedSurfaceVertex[] all = GpuTest.Read<PackedSurfaceVertex>(rig.Triangles.Vertices,
                (int)rig.Status().Vertices);
            var distinct = new HashSet<Vector3>();
            foreach (PackedSurfaceVertex vertex in all) distinct.Add(vertex.Position);
            return all.Length - distinct.Count;
        }

        private static bool IsCrossed(SurfaceGrid grid, float[] values, Vector3Int block)
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

        private static void CheckMesh(SurfaceMesh mesh, int euler)
        {
            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            MeshChecks.AssertNoDuplicates(mesh);
            Assert.AreEqual(euler, MeshChecks.EulerCharacteristic(mesh));
        }

        private static SurfaceGrid Box(Vector3 size, Vector3Int cells) => new SurfaceGrid(-0.5f * size, size, cells);

        private SurfaceMesh Polygonise(SurfaceGrid grid, Func<Vector3, float> value)
        {
            using (var rig = new BlockPolygonRig(shaders, grid,
                s => Mathf.Max(0f, value(grid.Position(s.x, s.y, s.z)))))
                return rig.Polygonise();
        }

        private static float[] Values(SurfaceGrid grid, Func<Vector3, float> value)
        {
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++)
            {
                values[i] = value(grid.Position(i % grid.Vertices.x, i / grid.Vertices.x % grid.Vertices.y,
                    i / (grid.Vertices.x * grid.Vertices.y)));
            }
            return values;
        }
    }
}
