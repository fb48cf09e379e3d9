using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Angles between the normals of a mesh and those of the shape that it should have.</summary>
    public readonly struct NormalError
    {
        private NormalError(double shading, double faces)
        {
            Shading = shading;
            Faces = faces;
        }

        /// <summary>Root mean square over the vertices' normals [degrees]; not a number where no vertex counts.</summary>
        public double Shading { get; }

        /// <summary>Root mean square over the triangles, weighted by area [degrees].</summary>
        public double Faces { get; }

        /// <summary>Measures.</summary>
        /// <param name="mesh">Any mesh.</param>
        /// <param name="truth">Unit normal of the shape at the point of it next to a position [m]; zero where nothing is to be
        /// measured.</param>
        public static NormalError Of(SurfaceMesh mesh, Func<Vector3, Vector3> truth)
        {
            double shading = 0.0, count = 0.0, faces = 0.0, area = 0.0;
            for (int i = 0; i < mesh.VertexCount; i++) Add(mesh.Normals[i], truth(mesh.Positions[i]), 1.0, ref shading, ref count);
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                Vector3 a = mesh.Positions[mesh.Indices[i]], b = mesh.Positions[mesh.Indices[i + 1]],
                    c = mesh.Positions[mesh.Indices[i + 2]];
                Vector3 normal = Vector3.Cross(b - a, c - a);
                Add(normal, truth((a + b + c) / 3f), normal.magnitude, ref faces, ref area);
            }
            return new NormalError(Math.Sqrt(shading / count), Math.Sqrt(faces / area));
        }

        private static void Add(Vector3 normal, Vector3 truth, double weight, ref double squares, ref double weights)
        {
            if (truth == Vector3.zero || normal == Vector3.zero) return;
            double degrees = Math.Atan2(Vector3.Cross(normal, truth).magnitude, Vector3.Dot(normal, truth)) * 180.0 / Math.PI;
            squares += weight * degrees * degrees;
            weights += weight;
        }
    }
}
