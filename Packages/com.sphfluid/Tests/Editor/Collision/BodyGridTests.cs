using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class BodyGridTests
    {
        const float Reach = 0.04f;

        static List<BodyTriangle> Soup(int count, int seed)
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
                triangles.Add(BodyTriangle.Of(a, b, c));
            }
            return triangles;
        }

        static HashSet<int> Listed(BodyGrid grid, Vector3 position)
        {
            var found = new HashSet<int>();
            Vector3 p = (position - grid.Origin) / grid.Side;
            var cell = new Vector3Int(Mathf.FloorToInt(p.x), Mathf.FloorToInt(p.y), Mathf.FloorToInt(p.z));
            if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= grid.Counts.x || cell.y >= grid.Counts.y || cell.z >= grid.Counts.z) return found;
            int index = cell.x + grid.Counts.x * (cell.y + grid.Counts.y * cell.z);
            for (uint r = grid.Starts[index]; r < grid.Starts[index + 1]; r++) found.Add((int)grid.References[(int)r]);
            return found;
        }

        [TestCase(false)]
        [TestCase(true)]
        public void ACellListsAllThatIsWithinReach(bool within)
        {
            List<BodyTriangle> triangles = Soup(211, 5);
            var domain = new Bounds(Vector3.zero, new Vector3(0.6f, 0.8f, 1f));
            var grid = new BodyGrid(triangles, 0, triangles.Count, Reach, within ? domain : (Bounds?)null);
            var random = new System.Random(6);
            int near = 0;
            for (int i = 0; i < 10000; i++)
            {
                Vector3 p = within ? Vector3.Scale(ParticleSets.RandomVector(random), domain.size) : 1.4f * ParticleSets.RandomVector(random);
                if (within && i % 10 == 0) p.x = domain.max.x; // a particle on a face
                if (i % 3 == 0) // on the cells' borders
                    p.y = grid.Origin.y + grid.Side * Mathf.Floor((p.y - grid.Origin.y) / grid.Side);
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
        public void TheMiddlesOfAWaysPartsListAllThatItMeets()
        {
            List<BodyTriangle> triangles = Soup(97, 8);
            var grid = new BodyGrid(triangles, 0, triangles.Count, Reach, null);
            var random = new System.Random(9);
            for (int i = 0; i < 3000; i++)
            {
                Vector3 from = 1.4f * ParticleSets.RandomVector(random), to = from + (float)random.NextDouble() * 8f * Reach * ParticleSets.RandomVector(random);
                int parts = 1 + (int)((to - from).magnitude / (1.7f * Reach));
                var listed = new HashSet<int>(Enumerable.Range(0, parts).SelectMany(k => Listed(grid, Vector3.LerpUnclamped(from, to, (k + 0.5f) / parts))));
                for (int t = 0; t < triangles.Count; t++)
                    for (int k = 0; k <= 20; k++)
                    {
                        Vector3 p = Vector3.LerpUnclamped(from, to, k / 20f);
                        if ((TriangleMath.ClosestPoint(p, triangles[t].A, triangles[t].B, triangles[t].C) - p).magnitude < 0.1f * Reach)
                            Assert.That(listed.Contains(t), Is.True, $"triangle {t} near the way {from} to {to}");
                    }
            }
        }
    }
}
