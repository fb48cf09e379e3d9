using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A triangle mesh of the liquid's surface: closed, each vertex shared by the triangles around it, triangles
    /// clockwise for a viewer outside the liquid as Unity expects.
    /// </summary>
    public sealed class SurfaceMesh
    {
        /// <summary>A mesh from its arrays, which it keeps.</summary>
        /// <param name="positions">Positions of the vertices [m].</param>
        /// <param name="normals">Unit normals out of the liquid, one a vertex.</param>
        /// <param name="indices">Vertices of the triangles, three a triangle.</param>
        /// <exception cref="ArgumentException">The arrays do not fit each other.</exception>
        public SurfaceMesh(Vector3[] positions, Vector3[] normals, int[] indices)
        {
            Positions = positions ?? throw new ArgumentNullException(nameof(positions));
            Normals = normals ?? throw new ArgumentNullException(nameof(normals));
            Indices = indices ?? throw new ArgumentNullException(nameof(indices));
            if (normals.Length != positions.Length)
            {
                throw new ArgumentException(
                    $"A mesh needs a normal for each vertex: {positions.Length} positions, {normals.Length} normals.", nameof(normals));
            }
            if (indices.Length % 3 != 0)
            {
                throw new ArgumentException($"A mesh needs three indices a triangle, not {indices.Length} in all.",
                    nameof(indices));
            }
        }

        /// <summary>Positions of the vertices [m].</summary>
        public Vector3[] Positions { get; }

        /// <summary>Unit normals out of the liquid.</summary>
        public Vector3[] Normals { get; }

        /// <summary>Vertices of the triangles, three a triangle.</summary>
        public int[] Indices { get; }

        /// <summary>Number of vertices.</summary>
        public int VertexCount => Positions.Length;

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => Indices.Length / 3;

        /// <summary>Area of all triangles [m^2].</summary>
        /// <returns>The sum, taken in double precision.</returns>
        public double Area()
        {
            double sum = 0.0;
            for (int i = 0; i < Indices.Length; i += 3)
            {
                sum += 0.5 * Vector3.Cross(Corner(i + 1) - Corner(i), Corner(i + 2) - Corner(i)).magnitude;
            }
            return sum;
        }

        /// <summary>Volume that the mesh encloses [m^3]; positive when its triangles face outwards.</summary>
        /// <returns>The sum of signed tetrahedra over the triangles, taken in double precision.</returns>
        public double Volume()
        {
            double sum = 0.0;
            for (int i = 0; i < Indices.Length; i += 3) sum += Vector3.Dot(Corner(i), Vector3.Cross(Corner(i + 1), Corner(i + 2))) / 6.0;
            return sum;
        }

        /// <summary>The same mesh elsewhere.</summary>
        /// <param name="matrix">Rotation and translation, e.g. <c>FluidSimulation.LocalToWorld</c>.</param>
        /// <returns>A new mesh.</returns>
        public SurfaceMesh Transformed(Matrix4x4 matrix)
        {
            var positions = new Vector3[Positions.Length];
            var normals = new Vector3[Normals.Length];
            for (int i = 0; i < positions.Length; i++)
            {
                positions[i] = matrix.MultiplyPoint3x4(Positions[i]);
                normals[i] = matrix.MultiplyVector(Normals[i]);
            }
            return new SurfaceMesh(positions, normals, (int[])Indices.Clone());
        }

        /// <summary>A mesh asset of Unity's with the same content.</summary>
        /// <param name="name">Name of the new mesh.</param>
        /// <returns>A mesh with 32-bit indices; the caller destroys it.</returns>
        public Mesh ToMesh(string name)
        {
            var mesh = new Mesh { name = name, indexFormat = IndexFormat.UInt32 };
            mesh.SetVertices(Positions);
            mesh.SetNormals(Normals);
            mesh.SetIndices(Indices, MeshTopology.Triangles, 0);
            mesh.RecalculateBounds();
            return mesh;
        }

        private Vector3 Corner(int index) => Positions[Indices[index]];
    }
}
