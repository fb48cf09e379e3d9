using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The compute twin on fields that are written by hand.</summary>
    public sealed class SurfacePolygoniserTests
    {
        private const float Iso = 0.5f;

        private FluidShaderSet shaders;
        private SurfacePolygoniser polygoniser;

        [SetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            polygoniser = new SurfacePolygoniser(shaders);
        }

        [TearDown]
        public void TearDown() => polygoniser.Dispose();

        [TestCase(64, 0.02)]
        [TestCase(32, 0.06)]
        public void SphereIsClosedOrientedAndOfTheRightSize(int cells, double tolerance)
        {
            const float radius = 0.31f;
            var centre = new Vector3(0.013f, -0.007f, 0.021f);
            SurfaceMesh mesh = Polygonise(Cube(1f, cells), p => Ball(p, centre, radius));

            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                Assert.Greater(Vector3.Dot(MeshChecks.FaceNormal(mesh, i), mesh.Positions[mesh.Indices[i]] - centre),
                    0f, $"triangle {i / 3} faces inwards");
            }
            for (int i = 0; i < mesh.VertexCount; i++)
            {
                Assert.Greater(Vector3.Dot(mesh.Normals[i], (mesh.Positions[i] - centre).normalized), 0.98f,
                    $"normal {i}");
            }
            Assert.AreEqual(1.0, mesh.Volume() / (4.0 / 3.0 * Math.PI * Math.Pow(radius, 3)), tolerance);
            Assert.AreEqual(1.0, mesh.Area() / (4.0 * Math.PI * radius * radius), tolerance);
        }

        [Test]
        public void SphereInLongCellsHasNormalsAlongItsRadii()
        {
            var grid = new SurfaceGrid(new Vector3(-1f, -0.5f, -0.25f), new Vector3(2f, 1f, 0.5f), 64);
            SurfaceMesh mesh = Polygonise(grid, p => Ball(p, Vector3.zero, 0.2f));
            MeshChecks.AssertClosed(mesh);
            for (int i = 0; i < mesh.VertexCount; i++)
            {
                Assert.Greater(Vector3.Dot(mesh.Normals[i], mesh.Positions[i].normalized), 0.97f, $"normal {i}");
            }
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        public void NoiseIsClosed(int seed)
        {
            var random = new System.Random(seed);
            SurfaceMesh mesh = Polygonise(Cube(1f, 32), _ => (float)random.NextDouble());
            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            Assert.Greater(mesh.TriangleCount, 50_000);
            Assert.Greater(mesh.Volume(), 0.0);
        }

        [Test]
        public void EmptyFieldGivesAnEmptyMesh()
        {
            SurfaceMesh mesh = Polygonise(Cube(1f, 32), _ => 0f);
            Assert.AreEqual(0, mesh.TriangleCount);
            Assert.AreEqual(0, mesh.VertexCount);
        }

        [Test]
        public void FullFieldIsTheDomainWithSharpEdges()
        {
            SurfaceGrid grid = Cube(2f, 32);
            SurfaceMesh mesh = Polygonise(grid, _ => 1f);
            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            Assert.AreEqual(8.0, mesh.Volume(), 0.02);
            Assert.AreEqual(24.0, mesh.Area(), 0.05);
            float cell = grid.CellSize.x;
            foreach (Vector3 p in mesh.Positions)
            {
                float fromWall = Mathf.Min(1f - Mathf.Abs(p.x), Mathf.Min(1f - Mathf.Abs(p.y), 1f - Mathf.Abs(p.z)));
                Assert.GreaterOrEqual(fromWall, 0f, $"{p} lies outside the domain");
                Assert.LessOrEqual(fromWall, 0.02f * cell, $"{p} lies off the wall");
            }
        }

        [Test]
        public void LiquidAgainstWallsEndsAtTheWalls()
        {
            SurfaceMesh mesh = Polygonise(Cube(1f, 32), p => Iso + 0.1f - p.y);
            MeshChecks.AssertClosed(mesh);
            MeshChecks.AssertSound(mesh);
            Assert.AreEqual(0.6, mesh.Volume(), 0.003);
            for (int i = 0; i < mesh.VertexCount; i++)
            {
                if (mesh.Normals[i].y > 0.5f) Assert.AreEqual(0.1f, mesh.Positions[i].y, 0.001f, $"{mesh.Positions[i]}");
            }
        }

        [Test]
        public void SameFieldGivesTheSameMesh()
        {
            using (SurfaceField field = Field(Cube(1f, 48), p => Ball(p, Vector3.zero, 0.3f)))
            {
                SurfaceMesh first = polygoniser.Polygonise(field, Iso);
                SurfaceMesh second = polygoniser.Polygonise(field, Iso);
                CollectionAssert.AreEqual(first.Indices, second.Indices);
                CollectionAssert.AreEqual(first.Positions, second.Positions);
                CollectionAssert.AreEqual(first.Normals, second.Normals);
            }
        }

        [Test]
        public void BufferGrowsToFitAndIsKept()
        {
            Assert.AreEqual(0, polygoniser.VertexCapacity);
            SurfaceMesh small = Polygonise(Cube(1f, 16), p => Ball(p, Vector3.zero, 0.2f));
            int capacity = polygoniser.VertexCapacity;
            Assert.GreaterOrEqual(capacity, small.Indices.Length);
            SurfaceMesh large = Polygonise(Cube(1f, 48), p => Ball(p, Vector3.zero, 0.4f));
            Assert.Greater(large.Indices.Length, capacity);
            Assert.GreaterOrEqual(polygoniser.VertexCapacity, large.Indices.Length);
            int grown = polygoniser.VertexCapacity;
            Polygonise(Cube(1f, 16), p => Ball(p, Vector3.zero, 0.2f));
            Assert.AreEqual(grown, polygoniser.VertexCapacity);
        }

        [Test]
        public void SurfaceLargerThanTheBufferIsRefusedByName()
        {
            using (var small = new SurfacePolygoniser(shaders, 300))
            using (SurfaceField field = Field(Cube(1f, 16), p => Ball(p, Vector3.zero, 0.3f)))
            {
                var exception = Assert.Throws<FluidDeviceException>(() => small.Polygonise(field, Iso));
                StringAssert.Contains("holds 100", exception.Message);
                StringAssert.Contains("Choose a smaller grid size", exception.Message);
            }
        }

        [Test]
        public void ASurfaceThatFillsTheBufferToTheLastCornerIsWhole()
        {
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, 16);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, p => 0.8f - p.magnitude))
            {
                SurfaceMesh expected = polygoniser.Polygonise(field);
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

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        public void IsoValueMustBePositive(float isoValue)
        {
            using (SurfaceField field = Field(Cube(1f, 8), _ => 1f))
                Assert.Throws<ArgumentOutOfRangeException>(() => polygoniser.Polygonise(field, isoValue));
        }

        [Test]
        public void GridLargerThanTheDeviceAllowsIsNamed()
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, SurfaceGrid.MaximumCells);
            if ((long)grid.VertexCount * sizeof(float) <= SystemInfo.maxGraphicsBufferSize)
            {
                Assert.Ignore("This device holds the largest grid.");
            }
            var exception = Assert.Throws<FluidDeviceException>(() => new SurfaceField(shaders, grid).Dispose());
            StringAssert.Contains("Choose a smaller grid size", exception.Message);
        }

        private static SurfaceGrid Cube(float edge, int cells) =>
            new SurfaceGrid(Vector3.one * (-0.5f * edge), Vector3.one * edge, cells);

        private static float Ball(Vector3 p, Vector3 centre, float radius) => Iso + (radius - (p - centre).magnitude);

        private SurfaceMesh Polygonise(SurfaceGrid grid, Func<Vector3, float> density)
        {
            using (SurfaceField field = Field(grid, density))
                return polygoniser.Polygonise(field, Iso);
        }

        private SurfaceField Field(SurfaceGrid grid, Func<Vector3, float> density) =>
            SurfaceTestScene.Field(shaders, grid, density);
    }
}
