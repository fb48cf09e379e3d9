using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class TerrainMeshTests
    {
        [TestCase(2, 2)]
        [TestCase(2, 7)]
        [TestCase(5, 3)]
        public void WithoutHolesItIsClosedAndHoldsTheVolumeBelow(int rows, int columns)
        {
            float[,] heights = Heights(rows, columns);
            TriangleMesh mesh = TerrainMesh.Make(heights, Surface(rows, columns), new Vector3(1f, 2f, 3f), 0.5f, 0.25f, -1f);
            Assert.That(mesh.OpenEdges(), Is.Empty);
            Assert.That(mesh.IsClosed);
            Assert.That(mesh.TriangleCount, Is.EqualTo(2 * (rows - 1) * (columns - 1) + 6 * (rows + columns - 2)));

            // A prism over each half of a cell, by the heights of its three corners.
            double volume = 0.0;
            for (int z = 0; z + 1 < rows; z++)
                for (int x = 0; x + 1 < columns; x++)
                {
                    double both = heights[z, x] + heights[z + 1, x + 1];
                    volume += 0.5 * 0.125 * ((both + heights[z + 1, x]) / 3.0 + 1.0 + (both + heights[z, x + 1]) / 3.0 + 1.0);
                }
            Assert.That(TestMeshes.Volume(mesh), Is.EqualTo(volume).Within(1e-5));
        }

        [Test]
        public void ACellIsPartedFromItsLowestCornerToItsHighest()
        {
            var heights = new float[2, 2] { { 0f, 1f }, { 1f, 0f } };
            TriangleMesh mesh = TerrainMesh.Make(heights, Surface(2, 2), Vector3.zero, 1f, 1f, -1f);
            Assert.That(mesh.Contains(new Vector3(0.5f, 0.02f, 0.49f)), Is.False, "the valley along the diagonal from (0, 0) to (1, 1)");
            Assert.That(mesh.Contains(new Vector3(0.21f, 0.4f, 0.79f)), Is.True, "beside it");
        }

        [Test]
        public void WithAHoleItIsASheet()
        {
            bool[,] surface = Surface(4, 4);
            surface[1, 1] = false;
            TriangleMesh mesh = TerrainMesh.Make(Heights(4, 4), surface, Vector3.zero, 1f, 1f, -1f);
            Assert.That(mesh.IsClosed, Is.False);
            Assert.That(mesh.TriangleCount, Is.EqualTo(16));
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                Assert.That(Vector3.Cross(b - a, c - a).y, Is.EqualTo(1f).Within(1e-4f), "faces up");
                Vector3 middle = (a + b + c) / 3f;
                Assert.That(middle.x > 1f && middle.x < 2f && middle.z > 1f && middle.z < 2f, Is.False, "the hole");
            }
        }

        private static float[,] Heights(int rows, int columns)
        {
            var heights = new float[rows, columns];
            for (int z = 0; z < rows; z++)
                for (int x = 0; x < columns; x++) heights[z, x] = 0.3f * Mathf.Sin(1.7f * x + 0.6f * z * z) + 0.1f * x;
            return heights;
        }

        private static bool[,] Surface(int rows, int columns)
        {
            var surface = new bool[rows - 1, columns - 1];
            for (int z = 0; z + 1 < rows; z++)
                for (int x = 0; x + 1 < columns; x++) surface[z, x] = true;
            return surface;
        }
    }
}
