using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>An affine map in double precision: where a point of one space lies in another.</summary>
    internal readonly struct AffineMap
    {
        // Rows of the linear part, then the offset.
        public readonly double M00, M01, M02, M10, M11, M12, M20, M21, M22;
        public readonly double X, Y, Z;

        public AffineMap(double m00, double m01, double m02, double m10, double m11, double m12, double m20, double m21, double m22,
            double x = 0.0, double y = 0.0, double z = 0.0)
        {
            (M00, M01, M02) = (m00, m01, m02);
            (M10, M11, M12) = (m10, m11, m12);
            (M20, M21, M22) = (m20, m21, m22);
            (X, Y, Z) = (x, y, z);
        }

        public static AffineMap Identity => new AffineMap(1, 0, 0, 0, 1, 0, 0, 0, 1);

        /// <summary>Determinant of the linear part.</summary>
        public double Determinant =>
            M00 * (M11 * M22 - M12 * M21) - M01 * (M10 * M22 - M12 * M20) + M02 * (M10 * M21 - M11 * M20);

        public AffineMap Transpose => new AffineMap(M00, M10, M20, M01, M11, M21, M02, M12, M22);

        /// <summary>The inverse; not finite where the linear part is singular.</summary>
        public AffineMap Inverse
        {
            get
            {
                double s = 1.0 / Determinant;
                var linear = new AffineMap(
                    (M11 * M22 - M12 * M21) * s, (M02 * M21 - M01 * M22) * s, (M01 * M12 - M02 * M11) * s,
                    (M12 * M20 - M10 * M22) * s, (M00 * M22 - M02 * M20) * s, (M02 * M10 - M00 * M12) * s,
                    (M10 * M21 - M11 * M20) * s, (M01 * M20 - M00 * M21) * s, (M00 * M11 - M01 * M10) * s);
                (double x, double y, double z) = linear.Turned(X, Y, Z);
                return linear.At(-x, -y, -z);
            }
        }

        public static AffineMap FromMatrix(in Matrix4x4 m) =>
            new AffineMap(m.m00, m.m01, m.m02, m.m10, m.m11, m.m12, m.m20, m.m21, m.m22, m.m03, m.m13, m.m23);

        /// <summary>The map, each element rounded once.</summary>
        public Matrix4x4 Matrix => new Matrix4x4(
            new Vector4((float)M00, (float)M10, (float)M20, 0f), new Vector4((float)M01, (float)M11, (float)M21, 0f),
            new Vector4((float)M02, (float)M12, (float)M22, 0f), new Vector4((float)X, (float)Y, (float)Z, 1f));

        /// <summary>The same linear part with another offset.</summary>
        public AffineMap At(double x, double y, double z) => new AffineMap(M00, M01, M02, M10, M11, M12, M20, M21, M22, x, y, z);

        /// <summary>First <paramref name="b"/>, then <paramref name="a"/>.</summary>
        public static AffineMap operator *(in AffineMap a, in AffineMap b)
        {
            (double x, double y, double z) = a.Turned(b.X, b.Y, b.Z);
            return new AffineMap(
                a.M00 * b.M00 + a.M01 * b.M10 + a.M02 * b.M20, a.M00 * b.M01 + a.M01 * b.M11 + a.M02 * b.M21,
                a.M00 * b.M02 + a.M01 * b.M12 + a.M02 * b.M22,
                a.M10 * b.M00 + a.M11 * b.M10 + a.M12 * b.M20, a.M10 * b.M01 + a.M11 * b.M11 + a.M12 * b.M21,
                a.M10 * b.M02 + a.M11 * b.M12 + a.M12 * b.M22,
                a.M20 * b.M00 + a.M21 * b.M10 + a.M22 * b.M20, a.M20 * b.M01 + a.M21 * b.M11 + a.M22 * b.M21,
                a.M20 * b.M02 + a.M21 * b.M12 + a.M22 * b.M22,
                x + a.X, y + a.Y, z + a.Z);
        }

        /// <summary>The linear part times a number; the same offset.</summary>
        public AffineMap Scaled(double s) =>
            new AffineMap(s * M00, s * M01, s * M02, s * M10, s * M11, s * M12, s * M20, s * M21, s * M22, X, Y, Z);

        /// <summary>The linear part times a number and plus another map's times a number; the offset of this one.</summary>
        public AffineMap Mixed(double a, in AffineMap other, double b) => new AffineMap(
            a * M00 + b * other.M00, a * M01 + b * other.M01, a * M02 + b * other.M02,
            a * M10 + b * other.M10, a * M11 + b * other.M11, a * M12 + b * other.M12,
            a * M20 + b * other.M20, a * M21 + b * other.M21, a * M22 + b * other.M22, X, Y, Z);

        /// <summary>The image of a point, rounded once.</summary>
        public Vector3 Apply(Vector3 p)
        {
            (double x, double y, double z) = Turned(p.x, p.y, p.z);
            return new Vector3((float)(x + X), (float)(y + Y), (float)(z + Z));
        }

        /// <summary>Largest difference of two linear parts' elements.</summary>
        public static double Difference(in AffineMap a, in AffineMap b)
        {
            AffineMap d = a.Mixed(1.0, b, -1.0);
            return Math.Max(Largest(d.M00, d.M01, d.M02), Math.Max(Largest(d.M10, d.M11, d.M12), Largest(d.M20, d.M21, d.M22)));
        }

        private (double, double, double) Turned(double x, double y, double z) =>
            (M00 * x + M01 * y + M02 * z, M10 * x + M11 * y + M12 * z, M20 * x + M21 * y + M22 * z);

        private static double Largest(double a, double b, double c) => Math.Max(Math.Abs(a), Math.Max(Math.Abs(b), Math.Abs(c)));
    }
}
