using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What must hold for every surface mesh.</summary>
    internal static class MeshChecks
    {
        /// <summary>
        /// Each side of a triangle belongs to exactly one other triangle, which runs along it in the other direction.
        /// </summary>
        public static void AssertClosed(SurfaceMesh mesh)
        {
            foreach (KeyValuePair<(int low, int high), (int up, int down)> edge in Edges(mesh))
            {
                (int up, int down) = edge.Value;
                Assert.IsTrue(up == 1 && down == 1,
                    $"{up + down} triangles at the edge {edge.Key}, {up} of them run along it upwards");
            }
        }

        /// <summary>No triangle without area, no vertex that is not a number, normals of unit length.</summary>
        public static void AssertSound(SurfaceMesh mesh)
        {
            for (int i = 0; i < mesh.VertexCount; i++)
            {
                Assert.IsFalse(float.IsNaN(mesh.Positions[i].sqrMagnitude), $"vertex {i} is {mesh.Positions[i]}");
                Assert.AreEqual(1f, mesh.Normals[i].magnitude, 1e-4f, $"normal {i}");
            }
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                Assert.Greater(FaceNormal(mesh, i).magnitude, 0f, $"triangle {i / 3} has no area");
            }
        }

        /// <summary>No two triangles with the same three corners.</summary>
        public static void AssertNoDuplicates(SurfaceMesh mesh)
        {
            var seen = new HashSet<(int, int, int)>();
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                var corners = new[] { mesh.Indices[i], mesh.Indices[i + 1], mesh.Indices[i + 2] };
                System.Array.Sort(corners);
                Assert.IsTrue(seen.Add((corners[0], corners[1], corners[2])), $"triangle {i / 3} is there twice");
            }
        }

        /// <summary>Vertices less edges plus triangles: 2 a ball, 0 a torus.</summary>
        public static int EulerCharacteristic(SurfaceMesh mesh) =>
            new HashSet<int>(mesh.Indices).Count - Edges(mesh).Count + mesh.TriangleCount;

        // By its lower and its higher vertex: the triangles that run along the edge from the lower to the higher one,
        // and those that run back.
        private static Dictionary<(int low, int high), (int up, int down)> Edges(SurfaceMesh mesh)
        {
            var edges = new Dictionary<(int low, int high), (int up, int down)>();
            for (int i = 0; i < mesh.Indices.Length; i++)
            {
                int from = mesh.Indices[i], to = mesh.Indices[i % 3 == 2 ? i - 2 : i + 1];
                (int low, int high) key = from < to ? (from, to) : (to, from);
                edges.TryGetValue(key, out (int up, int down) runs);
                edges[key] = from < to ? (runs.up + 1, runs.down) : (runs.up, runs.down + 1);
            }
            return edges;
        }

        /// <summary>Sides that belong to one triangle only.</summary>
        public static List<(Vector3 a, Vector3 b)> BoundarySides(SurfaceMesh mesh)
        {
            var sides = new HashSet<(int from, int to)>();
            for (int i = 0; i < mesh.Indices.Length; i++) sides.Add((mesh.Indices[i], mesh.Indices[i % 3 == 2 ? i - 2 : i + 1]));
            var boundary = new List<(Vector3 a, Vector3 b)>();
            foreach ((int from, int to) in sides)
            {
                if (!sides.Contains((to, from))) boundary.Add((mesh.Positions[from], mesh.Positions[to]));
            }
            return boundary;
        }

        /// <summary>
        /// The same triangles in any order: each has one in the other mesh whose corners lie within the tolerance.
        /// </summary>
        public static void AssertSameTriangles(SurfaceMesh expected, SurfaceMesh found, float tolerance)
        {
            Assert.AreEqual(expected.TriangleCount, found.TriangleCount, "triangles");
            Assert.AreEqual(expected.VertexCount, found.VertexCount, "vertices");
            int[] twins = NearestVertices(expected, found, tolerance);
            var triangles = new HashSet<(int, int, int)>();
            for (int i = 0; i < found.Indices.Length; i += 3)
            {
                triangles.Add(LowestFirst(found.Indices[i], found.Indices[i + 1], found.Indices[i + 2]));
            }
            for (int i = 0; i < expected.Indices.Length; i += 3)
            {
                (int, int, int) twin = LowestFirst(twins[expected.Indices[i]], twins[expected.Indices[i + 1]],
                    twins[expected.Indices[i + 2]]);
                Assert.IsTrue(triangles.Contains(twin),
                    $"triangle {i / 3} at {expected.Positions[expected.Indices[i]]} is missing");
            }
        }

        // Vertices of a mesh are farther apart than the tolerance, the edge of a cell of the hash.
        private static int[] NearestVertices(SurfaceMesh from, SurfaceMesh to, float tolerance)
        {
            var cells = new Dictionary<Vector3Int, int>();
            for (int i = 0; i < to.VertexCount; i++) cells[Vector3Int.FloorToInt(to.Positions[i] / tolerance)] = i;
            var nearest = new int[from.VertexCount];
            for (int i = 0; i < nearest.Length; i++)
            {
                nearest[i] = -1;
                Vector3Int centre = Vector3Int.FloorToInt(from.Positions[i] / tolerance);
                for (int k = 0; k < 27; k++)
                {
                    var neighbour = centre + new Vector3Int(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                    if (cells.TryGetValue(neighbour, out int other) &&
                        (to.Positions[other] - from.Positions[i]).magnitude <= tolerance)
                    {
                        nearest[i] = other;
                    }
                }
                Assert.GreaterOrEqual(nearest[i], 0,
                    $"no vertex at {from.Positions[i]:F9}; the nearest lies {Nearest(to, from.Positions[i])} m away");
            }
            return nearest;
        }

        private static float Nearest(SurfaceMesh mesh, Vector3 p)
        {
            float nearest = float.PositiveInfinity;
            foreach (Vector3 q in mesh.Positions) nearest = Mathf.Min(nearest, (q - p).magnitude);
            return nearest;
        }

        private static (int, int, int) LowestFirst(int a, int b, int c)
        {
            if (a < b && a < c) return (a, b, c);
            return b < c ? (b, c, a) : (c, a, b);
        }

        /// <summary>Twice the area along the side that a triangle faces.</summary>
        public static Vector3 FaceNormal(SurfaceMesh mesh, int firstIndex)
        {
            Vector3 a = mesh.Positions[mesh.Indices[firstIndex]];
            Vector3 b = mesh.Positions[mesh.Indices[firstIndex + 1]];
            Vector3 c = mesh.Positions[mesh.Indices[firstIndex + 2]];
            return Vector3.Cross(b - a, c - a);
        }
    }
}
