using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Small meshes of known shape.</summary>
    internal static class TestMeshes
    {
        /// <summary>Cube of edge 1 round the origin as a Unity mesh, four vertices a face, as importers make it.</summary>
        public static Mesh Cube()
        {
            TriangleMesh box = PrimitiveTessellator.Box(Matrix4x4.identity);
            var vertices = new Vector3[box.Indices.Length];
            var indices = new int[box.Indices.Length];
            for (int i = 0; i < indices.Length; i++)
            {
                vertices[i] = box.Vertices[box.Indices[i]];
                indices[i] = i;
            }
            return new Mesh { name = "Test Cube", vertices = vertices, triangles = indices };
        }

        /// <summary>Two triangles in the plane y = 0, one metre wide, facing up.</summary>
        public static TriangleMesh Sheet() => new TriangleMesh(
            new[] { new Vector3(-0.5f, 0f, -0.5f), new Vector3(-0.5f, 0f, 0.5f), new Vector3(0.5f, 0f, 0.5f),
                new Vector3(0.5f, 0f, -0.5f) },
            new[] { 0, 1, 2, 0, 2, 3 });

        /// <summary>Sphere round the origin.</summary>
        public static TriangleMesh Sphere(float radius, float chordError) =>
            PrimitiveTessellator.Capsule(Matrix4x4.identity, radius, 0f, chordError);

        /// <summary>Volume enclosed by outward triangles [m³]: Σ A·(B×C)/6.</summary>
        public static double Volume(TriangleMesh mesh)
        {
            double volume = 0.0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                volume += Vector3.Dot(a, Vector3.Cross(b, c)) / 6.0;
            }
            return volume;
        }
    }
}
