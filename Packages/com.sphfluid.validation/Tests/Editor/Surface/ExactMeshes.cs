using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Meshes of which everything is known.</summary>
    internal static class ExactMeshes
    {
        /// <summary>A regular tetrahedron with edges of 2√2 about the origin, facing outwards.</summary>
        public static SurfaceMesh Tetrahedron() => Of(
            new[] { new Vector3(1f, 1f, 1f), new Vector3(1f, -1f, -1f), new Vector3(-1f, 1f, -1f), new Vector3(-1f, -1f, 1f) },
            new[] { 0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2 });

        /// <summary>A box between two corners, facing outwards.</summary>
        public static SurfaceMesh Box(Vector3 low, Vector3 high)
        {
            var corners = new Vector3[8];
            for (int i = 0; i < 8; i++)
            {
                corners[i] = new Vector3((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
            }
            return Of(corners, new[]
            {
                0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
                0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
            });
        }

        /// <summary>A ring of squares cut in halves about the y axis, with the exact normals of a torus.</summary>
        public static SurfaceMesh Torus(float ring, float tube, int steps)
        {
            var positions = new Vector3[steps * steps];
            var normals = new Vector3[steps * steps];
            var indices = new List<int>();
            for (int i = 0; i < steps; i++)
                for (int j = 0; j < steps; j++)
                {
                    double u = 2.0 * Math.PI * i / steps, v = 2.0 * Math.PI * j / steps;
                    var outwards = new Vector3((float)Math.Cos(u), 0f, (float)Math.Sin(u));
                    Vector3 normal = (float)Math.Cos(v) * outwards + (float)Math.Sin(v) * Vector3.up;
                    normals[i * steps + j] = normal;
                    positions[i * steps + j] = ring * outwards + tube * normal;
                    int a = i * steps + j, b = (i + 1) % steps * steps + j, c = (i + 1) % steps * steps + (j + 1) % steps,
                        d = i * steps + (j + 1) % steps;
                    indices.AddRange(new[] { a, d, c, a, c, b });
                }
            return new SurfaceMesh(positions, normals, indices.ToArray());
        }

        /// <summary>A surface y = height(x, z) over squares of one metre from the origin, facing upwards.</summary>
        public static SurfaceMesh Terrain(int across, int deep, Func<float, float, float> height)
        {
            var positions = new List<Vector3>();
            var indices = new List<int>();
            for (int z = 0; z <= deep; z++)
                for (int x = 0; x <= across; x++)
                {
                    positions.Add(new Vector3(x, height(x, z), z));
                    if (x == across || z == deep) continue;
                    int a = z * (across + 1) + x, b = a + 1, d = a + across + 1;
                    indices.AddRange(new[] { a, d, b, b, d, d + 1 });
                }
            return Of(positions.ToArray(), indices.ToArray());
        }

        /// <summary>Both meshes in one.</summary>
        public static SurfaceMesh Both(SurfaceMesh a, SurfaceMesh b) => new SurfaceMesh(a.Positions.Concat(b.Positions).ToArray(),
            a.Normals.Concat(b.Normals).ToArray(), a.Indices.Concat(b.Indices.Select(i => i + a.VertexCount)).ToArray());

        /// <summary>The same vertices with other triangles.</summary>
        public static SurfaceMesh With(SurfaceMesh mesh, IEnumerable<int> indices) =>
            new SurfaceMesh(mesh.Positions, mesh.Normals, indices.ToArray());

        private static SurfaceMesh Of(Vector3[] positions, int[] indices) =>
            new SurfaceMesh(positions, Array.ConvertAll(positions, _ => Vector3.up), indices);
    }
}
