using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>How well shaped the triangles of a mesh are, by the smallest angle of each.</summary>
    public readonly struct TriangleShapes
    {
        // Of the square of a cell's edge; rounding leaves less in triangles whose corners coincide.
        private const float AreaLimit = 1e-7f;

        private TriangleShapes(double least, double percentile, double mean, int zeroArea)
        {
            LeastAngle = least;
            OnePercentAngle = percentile;
            MeanAngle = mean;
            ZeroArea = zeroArea;
        }

        /// <summary>Smallest angle of all [degrees]; not a number without triangles.</summary>
        public double LeastAngle { get; }

        /// <summary>One triangle in a hundred has a smaller smallest angle [degrees].</summary>
        public double OnePercentAngle { get; }

        /// <summary>Mean over the triangles of their smallest angle [degrees]; 60 for equilateral ones.</summary>
        public double MeanAngle { get; }

        /// <summary>Triangles smaller than 1e-7 of a cell's face.</summary>
        public int ZeroArea { get; }

        /// <summary>Measures.</summary>
        /// <param name="mesh">Any mesh.</param>
        /// <param name="cell">Edge of the cells that it was made in [m].</param>
        public static TriangleShapes Of(SurfaceMesh mesh, float cell)
        {
            var angles = new double[mesh.TriangleCount];
            int zeroArea = 0;
            double sum = 0.0;
            for (int i = 0; i < angles.Length; i++)
            {
                Vector3 a = Corner(mesh, 3 * i), b = Corner(mesh, 3 * i + 1), c = Corner(mesh, 3 * i + 2);
                zeroArea += 0.5f * Vector3.Cross(b - a, c - a).magnitude < AreaLimit * cell * cell ? 1 : 0;
                angles[i] = Math.Min(Angle(a, b, c), Math.Min(Angle(b, c, a), Angle(c, a, b)));
                sum += angles[i];
            }
            if (angles.Length == 0) return new TriangleShapes(double.NaN, double.NaN, double.NaN, 0);
            Array.Sort(angles);
            return new TriangleShapes(angles[0], angles[angles.Length / 100], sum / angles.Length, zeroArea);
        }

        private static Vector3 Corner(SurfaceMesh mesh, int i) => mesh.Positions[mesh.Indices[i]];

        private static double Angle(Vector3 at, Vector3 b, Vector3 c)
        {
            Vector3 u = b - at, v = c - at;
            return Math.Atan2(Vector3.Cross(u, v).magnitude, Vector3.Dot(u, v)) * 180.0 / Math.PI;
        }
    }
}
