using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What must hold for every surface mesh.</summary>
    static class MeshChecks
    {
        /// <summary>Each side of a triangle belongs to exactly one other triangle, which runs along it the other way.</summary>
        public static void AssertClosed(SurfaceMesh mesh)
        {
            var sides = new HashSet<(int from, int to)>();
            for (int i = 0; i < mesh.Indices.Length; i++)
            {
                int next = i % 3 == 2 ? i - 2 : i + 1;
                Assert.IsTrue(sides.Add((mesh.Indices[i], mesh.Indices[next])), $"two triangles share a side in the same direction, at index {i}");
            }
            foreach ((int from, int to) in sides)
                Assert.IsTrue(sides.Contains((to, from)), $"open side between {mesh.Positions[from]} and {mesh.Positions[to]}");
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
                Assert.Greater(FaceNormal(mesh, i).magnitude, 0f, $"triangle {i / 3} has no area");
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
