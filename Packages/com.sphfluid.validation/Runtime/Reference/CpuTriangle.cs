using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A triangle in simulation space [m]; cross(B − A, C − A) points to the front. Queries as in TriangleQueries.hlsl.</summary>
    internal struct CpuTriangle
    {
        public double3 A;
        public double3 B;
        public double3 C;

        /// <summary>From a point to the nearest one of a triangle [m].</summary>
        public static Vector3 Separation(Vector3 p, Vector3 a, Vector3 b, Vector3 c)
        {
            var triangle =
                new CpuTriangle { A = CpuFluidParticle.Double(a), B = CpuFluidParticle.Double(b), C = CpuFluidParticle.Double(c) };
            double3 from = CpuFluidParticle.Double(p);
            return (float3)(triangle.ClosestPoint(from, out _) - from);
        }

        /// <summary>Nearest point (Ericson 5.1.5); onFace: the perpendicular from p falls inside the triangle.</summary>
        public double3 ClosestPoint(double3 p, out bool onFace)
        {
            double3 ab = B - A;
            double3 ac = C - A;
            double d1 = math.dot(ab, p - A);
            double d2 = math.dot(ac, p - A);
            double d3 = math.dot(ab, p - B);
            double d4 = math.dot(ac, p - B);
            double d5 = math.dot(ab, p - C);
            double d6 = math.dot(ac, p - C);
            double va = d3 * d6 - d5 * d4;
            double vb = d5 * d2 - d1 * d6;
            double vc = d1 * d4 - d3 * d2;
            double e = d4 - d3;
            double f = d5 - d6;
            onFace = false;
            if (d1 <= 0.0 && d2 <= 0.0) return A;

            if (d3 >= 0.0 && d4 <= d3) return B;

            if (d6 >= 0.0 && d5 <= d6) return C;

            if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return A + ab * (d1 / (d1 - d3));

            if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return A + ac * (d2 / (d2 - d6));

            if (va <= 0.0 && e >= 0.0 && f >= 0.0) return B + (C - B) * (e / (e + f));

            onFace = true;
            double scale = 1.0 / (va + vb + vc);
            return A + ab * (vb * scale) + ac * (vc * scale);
        }

        /// <summary>
        /// Fraction of the segment from p along move at which it intersects the triangle (Möller and Trumbore), 2 where it does not.
        /// </summary>
        public double SegmentFraction(double3 p, double3 move)
        {
            double3 ab = B - A;
            double3 ac = C - A;
            double3 h = math.cross(move, ac);
            double determinant = math.dot(ab, h);
            if (math.abs(determinant) <= 1e-30) return 2.0;

            double3 s = p - A;
            double3 q = math.cross(s, ab);
            double u = math.dot(s, h) / determinant;
            double v = math.dot(move, q) / determinant;
            double t = math.dot(ac, q) / determinant;
            return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= 1.0 ? t : 2.0;
        }
    }

    /// <summary>One mesh: its triangles and their box [m].</summary>
    internal struct CpuMesh
    {
        public double3 BoundsMin;
        public double3 BoundsMax;
        public int FirstTriangle;
        public int EndTriangle;
        public bool Closed;
    }
}
