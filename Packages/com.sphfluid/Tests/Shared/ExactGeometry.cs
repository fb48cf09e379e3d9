using System;
using System.Numerics;
using Vector3 = UnityEngine.Vector3;

namespace SphFluid.Tests
{
    /// <summary>Whether segments intersect triangles, by orientation signs that are exact for float coordinates.</summary>
    internal static class ExactGeometry
    {
        /// <summary>
        /// Whether the closed segment intersects the closed triangle. A segment within the triangle's plane does not count.
        /// </summary>
        public static bool Intersects(Vector3 p, Vector3 q, Vector3 a, Vector3 b, Vector3 c)
        {
            int s0 = Orientation(a, b, c, p), s1 = Orientation(a, b, c, q);
            if (s0 * s1 > 0 || s0 == 0 && s1 == 0) return false;
            int u = Orientation(p, q, a, b), v = Orientation(p, q, b, c), w = Orientation(p, q, c, a);
            return u >= 0 && v >= 0 && w >= 0 || u <= 0 && v <= 0 && w <= 0;
        }

        /// <summary>Distance to the triangle, in double: right for needles.</summary>
        public static double Distance(Vector3 point, Vector3 a, Vector3 b, Vector3 c)
        {
            Double3 p = point, normal = Double3.Cross((Double3)b - a, (Double3)c - a);
            double nearest = Math.Min(FromEdge(p, a, b), Math.Min(FromEdge(p, b, c), FromEdge(p, c, a)));
            bool inside = normal.Length > 0.0 && Faces(p, a, b, normal) && Faces(p, b, c, normal) && Faces(p, c, a, normal);
            return inside ? Math.Min(nearest, Math.Abs(Double3.Dot(p - a, normal)) / normal.Length) : nearest;
        }

        private static bool Faces(Double3 p, Double3 a, Double3 b, Double3 normal) =>
            Double3.Dot(Double3.Cross(b - a, p - a), normal) >= 0.0;

        private static double FromEdge(Double3 p, Double3 a, Double3 b)
        {
            Double3 edge = b - a;
            double squared = Double3.Dot(edge, edge),
                u = squared > 0.0 ? Math.Min(1.0, Math.Max(0.0, Double3.Dot(p - a, edge) / squared)) : 0.0;
            return (p - a - u * edge).Length;
        }

        /// <summary>Sign of det(b − a, c − a, d − a).</summary>
        public static int Orientation(Vector3 a, Vector3 b, Vector3 c, Vector3 d)
        {
            // Differences of floats of like size are exact in double.
            double ax = (double)b.x - a.x, ay = (double)b.y - a.y, az = (double)b.z - a.z;
            double bx = (double)c.x - a.x, by = (double)c.y - a.y, bz = (double)c.z - a.z;
            double cx = (double)d.x - a.x, cy = (double)d.y - a.y, cz = (double)d.z - a.z;
            double value = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
            double size = Math.Abs(ax) * (Math.Abs(by * cz) + Math.Abs(bz * cy)) + Math.Abs(ay) * (Math.Abs(bz * cx) + Math.Abs(bx * cz)) +
                Math.Abs(az) * (Math.Abs(bx * cy) + Math.Abs(by * cx));
            return Math.Abs(value) > 1e-14 * size ? Math.Sign(value) : ExactOrientation(a, b, c, d);
        }

        private static int ExactOrientation(Vector3 a, Vector3 b, Vector3 c, Vector3 d)
        {
            BigInteger ax = Difference(b.x, a.x), ay = Difference(b.y, a.y), az = Difference(b.z, a.z);
            BigInteger bx = Difference(c.x, a.x), by = Difference(c.y, a.y), bz = Difference(c.z, a.z);
            BigInteger cx = Difference(d.x, a.x), cy = Difference(d.y, a.y), cz = Difference(d.z, a.z);
            return (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)).Sign;
        }

        private static BigInteger Difference(float a, float b) => Whole(a) - Whole(b);

        // In units of the smallest float, 2^-149.
        private static BigInteger Whole(float value)
        {
            int bits = BitConverter.SingleToInt32Bits(value), exponent = bits >> 23 & 255, mantissa = bits & 0x7fffff;
            BigInteger whole = exponent == 0 ? mantissa : new BigInteger(mantissa | 0x800000) << (exponent - 1);
            return bits < 0 ? -whole : whole;
        }
    }
}
