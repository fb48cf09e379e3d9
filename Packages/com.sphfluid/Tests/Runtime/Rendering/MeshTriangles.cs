using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The triangles that a mesh holds on the GPU.</summary>
    internal static class MeshTriangles
    {
        // float3 position, float3 normal.
        private const int VertexFloats = 6;

        /// <summary>
        /// Corners of all triangles with area that the mesh holds on the GPU, three a triangle; the rest must be the tail.
        /// </summary>
        public static List<Vector3> Read(Mesh mesh, Matrix4x4 matrix)
        {
            Assert.AreEqual(mesh.GetIndexCount(0), (uint)(mesh.GetIndexCount(0) / 3 * 3));
            var corners = new List<Vector3>();
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0))
            using (GraphicsBuffer indices = mesh.GetIndexBuffer())
            {
                float[] values = GpuTest.Read<float>(vertices, vertices.count * VertexFloats);
                uint[] order = GpuTest.Read<uint>(indices, indices.count);
                bool tail = false;
                for (int i = 0; i < order.Length; i += 3)
                {
                    bool empty = order[i] == 0 && order[i + 1] == 0 && order[i + 2] == 0;
                    Assert.IsFalse(tail && !empty, $"triangle {i / 3} after the first one without area");
                    tail = empty;
                    for (int corner = 0; corner < 3 && !empty; corner++)
                    {
                        int at = (int)order[i + corner] * VertexFloats;
                        corners.Add(matrix.MultiplyPoint3x4(new Vector3(values[at], values[at + 1], values[at + 2])));
                    }
                }
            }
            return corners;
        }

        /// <summary>Triangles in an order that does not depend on how the GPU met them, each from its smallest corner on.</summary>
        public static List<string> Ordered(List<Vector3> corners)
        {
            var lines = new List<string>(corners.Count / 3);
            for (int i = 0; i < corners.Count; i += 3)
            {
                var texts = new[] { Text(corners[i]), Text(corners[i + 1]), Text(corners[i + 2]) };
                int first = Array.IndexOf(texts, Smallest(texts));
                lines.Add(texts[first] + texts[(first + 1) % 3] + texts[(first + 2) % 3]);
            }
            lines.Sort(string.CompareOrdinal);
            return lines;
        }

        private static string Smallest(string[] texts)
        {
            string smallest = texts[0];
            foreach (string text in texts) smallest = string.CompareOrdinal(text, smallest) < 0 ? text : smallest;
            return smallest;
        }

        // Adding 0 makes -0 and 0 the same.
        private static string Text(Vector3 v) => $"({v.x + 0f:R} {v.y + 0f:R} {v.z + 0f:R})";

        /// <summary>Volume of the tetrahedra between a point and the triangles; of a closed mesh the point does not matter.</summary>
        public static double Volume(List<Vector3> corners, Vector3 origin)
        {
            double sum = 0.0;
            for (int i = 0; i < corners.Count; i += 3)
            {
                sum += Vector3.Dot(corners[i] - origin, Vector3.Cross(corners[i + 1] - origin, corners[i + 2] - origin)) / 6.0;
            }
            return sum;
        }
    }
}
