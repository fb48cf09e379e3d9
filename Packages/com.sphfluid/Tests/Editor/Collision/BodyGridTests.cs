using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class BodyGridTests
    {
        private const float Reach = 0.04f;

        private static List<BodyTriangle> Soup(int count, int seed)
        {
            var random = new System.Random(seed);
            var triangles = new List<BodyTriangle>();
            for (int i = 0; i < count; i++)
            {
                Vector3 a = ParticleSets.RandomVector(random);
                float size = Mathf.Pow(10f, -2f * (float)random.NextDouble());
                Vector3 b = a + size * ParticleSets.RandomVector(random), c = a + size * ParticleSets.RandomVector(random);
                if (i % 5 == 0) c = b + 1e-4f * (c - b); // needles
                if (i % 7 == 0) b.y = c.y = a.y;         // along the cells
                triangles.Add(BodyTriangle.Create(a, b, c));
            }
            return triangles;
        }

        private static HashSet<int> Listed(BodyGrid grid, Vector3 position)
        {
            BodyCells cells = grid.Cells;
            Vector3 p = (position - cells.Origin) / cells.Side;
            int x = Mathf.FloorToInt(p.x), y = Mathf.FloorToInt(p.y), z = Mathf.FloorToInt(p.z);
            bool inside = x >= 0 && y >= 0 && z >= 0 && x < cells.CountX && y < cells.CountY && z < cells.CountZ;
            return new HashSet<int>(inside ? List(grid, x + cells.CountX * (y + cells.CountY * z)) : Enumerable.Empty<int>());
        }

        private static IEnumerable<int> List(BodyGrid grid, int cell)
        {
            for (uint r = grid.Starts[cell]; r < grid.Starts[cell + 1]; r++) yield return (int)grid.References[(int)r];
        }

        // Whether a cell's cube is within the reach of a triangle's box and of its plane.
        private static bool Intersects(BodyCells cells, BodyTriangle tri, int x, int y, int z)
        {
            double reach = cells.Reach * (1.0 + 1e-4) + 1e-4 * cells.Side, across = 0.0, spread = 0.0, apart = 0.0;
            var cell = new Vector3Int(x, y, z);
            for (int axis = 0; axis < 3; axis++)
            {
                double low = Mathf.Min(tri.A[axis], Mathf.Min(tri.B[axis], tri.C[axis])),
                    high = Mathf.Max(tri.A[axis], Mathf.Max(tri.B[axis], tri.C[axis]));
                double middle = cells.Origin[axis] + (cell[axis] + 0.5) * cells.Side, half = 0.5 * cells.Side;
                double gap = Math.Max(0.0, Math.Max(low - (middle + half), middle - half - high));
                apart += gap * gap;
                double normal = axis == 0 ? tri.NormalX : axis == 1 ? tri.NormalY : tri.NormalZ;
                across += (middle - tri.A[axis]) * normal;
                spread += half * Math.Abs(normal);
            }
            return apart <= reach * reach && Math.Abs(across) <= spread + reach;
        }

        [TestCase(1, false)]
        [TestCase(2, true)]
        [TestCase(101, false)]
        [TestCase(101, true)]
        public void TheJobsListWhatIsWithinReachOfEachCellInTheTrianglesOrder(int count, bool within)
        {
            BodyTriangle[] triangles = Soup(count, 11).ToArray();
            Bounds? bounds = within ? new Bounds(Vector3.zero, new Vector3(0.6f, 0.8f, 1f)) : (Bounds?)null;
            using (var grid = new BodyGrid(triangles, null, 4f * Reach, bounds, 1000u, 77u))
            {
                BodyCells cells = grid.Cells;
                Assert.That(grid.Starts.Length, Is.EqualTo(cells.Count + 1));
                Assert.That(grid.Starts[0], Is.EqualTo(77u));
                Assert.That(grid.Starts[cells.Count] - 77u, Is.EqualTo((uint)grid.References.Length));
                for (int cell = 0; cell < cells.Count; cell++)
                {
                    int x = cell % cells.CountX, y = cell / cells.CountX % cells.CountY, z = cell / cells.CountX / cells.CountY;
                    uint[] expected = Enumerable.Range(0, count).Where(t => Intersects(cells, triangles[t], x, y, z))
                        .Select(t => 1000u + (uint)t).ToArray();
                    int first = (int)(grid.Starts[cell] - 77u), length = (int)(grid.Starts[cell + 1] - grid.Starts[cell]);
                    Assert.That(grid.References.GetSubArray(first, length).ToArray(), Is.EqualTo(expected), $"cell {x}, {y}, {z}");
                }
            }
        }

        [Test]
        public void CellsGrowUntilTheyAreFewEnough()
        {
            BodyCells cells = BodyCells.Over(-5f * Vector3.one, 5f * Vector3.one, 0.1f, 0.05f, 1000);
            Assert.That(cells.Count, Is.LessThanOrEqualTo(1000).And.GreaterThan(200));
            Assert.That(cells.CountX * cells.Side, Is.GreaterThanOrEqualTo(10f));
        }

        // 200,000 triangles in some hundred cells each would be more than 16 million entries.
        [Test]
        public void ListsThatWouldBeTooLongAreOfLargerCells()
        {
            BodyTriangle[] Large(int count) => Enumerable.Range(0, count)
                .Select(i => BodyTriangle.Create(new Vector3(-1f, -1f, 1e-3f * i), new Vector3(1f, 1f, 1e-3f * i),
                    new Vector3(-1f, -1f, 1e-3f * i + 1f))).ToArray();
            using (var few = new BodyGrid(Large(3), null, 1f, null))
            using (var many = new BodyGrid(Large(80000), null, 1f, null))
            {
                Assert.That(few.Cells.Side, Is.EqualTo(0.5f));
                Assert.That(many.Cells.Side, Is.EqualTo(1f));
            }
        }

        [TestCase(false)]
        [TestCase(true)]
        public void ACellListsAllThatIsWithinReach(bool within)
        {
            List<BodyTriangle> triangles = Soup(211, 5);
            var domain = new Bounds(Vector3.zero, new Vector3(0.6f, 0.8f, 1f));
            using var grid = new BodyGrid(triangles.ToArray(), null, Reach, within ? domain : (Bounds?)null);
            var random = new System.Random(6);
            int near = 0;
            for (int i = 0; i < 10000; i++)
            {
                Vector3 p = within ? Vector3.Scale(ParticleSets.RandomVector(random), domain.size)
                    : 1.4f * ParticleSets.RandomVector(random);
                if (within && i % 10 == 0) p.x = domain.max.x; // a particle on a face
                if (i % 3 == 0) // on the cells' borders
                    p.y = grid.Cells.Origin.y + grid.Cells.Side * Mathf.Floor((p.y - grid.Cells.Origin.y) / grid.Cells.Side);
                if (within) p = Vector3.Max(domain.min, Vector3.Min(domain.max, p));
                HashSet<int> listed = Listed(grid, p);
                for (int t = 0; t < triangles.Count; t++)
                {
                    if ((TriangleMath.ClosestPoint(p, triangles[t].A, triangles[t].B, triangles[t].C) - p).magnitude > Reach) continue;
                    near++;
                    Assert.That(listed.Contains(t), Is.True, $"triangle {t} near {p}");
                }
            }
            Assert.That(near, Is.GreaterThan(1000));
        }

        [Test]
        public void ACellListsWhatComesWithinReachAsItDeforms()
        {
            List<BodyTriangle> triangles = Soup(101, 5);
            var random = new System.Random(7);
            Vector3 Near(Vector3 corner) => corner + 2f * Reach * ParticleSets.RandomVector(random);
            BodyTriangle[] ends = triangles.Select(t => BodyTriangle.Create(Near(t.A), Near(t.B), Near(t.C))).ToArray();
            using var grid = new BodyGrid(triangles.ToArray(), ends, Reach, null);
            int near = 0, listedInAll = 0;
            for (int i = 0; i < 3000; i++)
            {
                Vector3 p = 1.4f * ParticleSets.RandomVector(random);
                HashSet<int> listed = Listed(grid, p);
                listedInAll += listed.Count;
                for (int t = 0; t < triangles.Count; t++)
                    for (int k = 0; k <= 10; k++)
                    {
                        Vector3 At(Vector3 a, Vector3 b) => Vector3.LerpUnclamped(a, b, 0.1f * k);
                        BodyTriangle s = triangles[t], e = ends[t];
                        if ((TriangleMath.ClosestPoint(p, At(s.A, e.A), At(s.B, e.B), At(s.C, e.C)) - p).magnitude > Reach) continue;
                        near++;
                        Assert.That(listed.Contains(t), Is.True, $"triangle {t} near {p}");
                    }
            }
            Assert.That(near, Is.GreaterThan(1000));
            Assert.That(listedInAll, Is.LessThan(0.5 * 3000 * triangles.Count), "most are not listed");
        }

        [Test]
        public void TheMiddlesOfAPathsPartsListAllThatItIntersects()
        {
            List<BodyTriangle> triangles = Soup(97, 8);
            using var grid = new BodyGrid(triangles.ToArray(), null, Reach, null);
            var random = new System.Random(9);
            for (int i = 0; i < 3000; i++)
            {
                Vector3 from = 1.4f * ParticleSets.RandomVector(random),
                    to = from + (float)random.NextDouble() * 8f * Reach * ParticleSets.RandomVector(random);
                int parts = 1 + (int)((to - from).magnitude / (1.7f * Reach));
                var listed = new HashSet<int>(Enumerable.Range(0, parts)
                    .SelectMany(k => Listed(grid, Vector3.LerpUnclamped(from, to, (k + 0.5f) / parts))));
                for (int t = 0; t < triangles.Count; t++)
                    for (int k = 0; k <= 20; k++)
                    {
                        Vector3 p = Vector3.LerpUnclamped(from, to, k / 20f);
                        if ((TriangleMath.ClosestPoint(p, triangles[t].A, triangles[t].B, triangles[t].C) - p).magnitude < 0.1f * Reach)
                        {
                            Assert.That(listed.Contains(t), Is.True, $"triangle {t} near the path {from} to {to}");
                        }
                    }
            }
        }
    }
}
