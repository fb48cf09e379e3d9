using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Double-precision determinant and inverse of affine transforms, and the test for flattened ones.</summary>
    internal static class AffineMath
    {
        /// <summary>Determinant of the linear part.</summary>
        public static double Determinant(in Matrix4x4 m) =>
            (double)m.m00 * ((double)m.m11 * m.m22 - (double)m.m12 * m.m21) -
            (double)m.m01 * ((double)m.m10 * m.m22 - (double)m.m12 * m.m20) +
            (double)m.m02 * ((double)m.m10 * m.m21 - (double)m.m11 * m.m20);

        /// <summary>
        /// Whether the transform flattens space: a column is zero or not finite, or the columns are so nearly in a
        /// plane that their determinant is below 1e-6 of the product of their lengths.
        /// </summary>
        public static bool IsSingular(in Matrix4x4 m)
        {
            double product = Length(m, 0) * Length(m, 1) * Length(m, 2);
            double determinant = Math.Abs(Determinant(m));
            bool finite = !double.IsNaN(product) && !double.IsInfinity(product) && IsFinite(m.GetColumn(3));
            return !finite || product < 1e-30 || !(determinant > 1e-6 * product);
        }

        /// <summary>Inverse of an affine transform.</summary>
        /// <returns>False when the transform is singular; the inverse is then zero.</returns>
        public static bool TryInvert(in Matrix4x4 m, out Matrix4x4 inverse)
        {
            inverse = Matrix4x4.zero;
            if (IsSingular(m)) return false;
            double scale = 1.0 / Determinant(m);
            inverse.m00 = Cofactor(m.m11, m.m22, m.m12, m.m21, scale);
            inverse.m01 = Cofactor(m.m02, m.m21, m.m01, m.m22, scale);
            inverse.m02 = Cofactor(m.m01, m.m12, m.m02, m.m11, scale);
            inverse.m10 = Cofactor(m.m12, m.m20, m.m10, m.m22, scale);
            inverse.m11 = Cofactor(m.m00, m.m22, m.m02, m.m20, scale);
            inverse.m12 = Cofactor(m.m02, m.m10, m.m00, m.m12, scale);
            inverse.m20 = Cofactor(m.m10, m.m21, m.m11, m.m20, scale);
            inverse.m21 = Cofactor(m.m01, m.m20, m.m00, m.m21, scale);
            inverse.m22 = Cofactor(m.m00, m.m11, m.m01, m.m10, scale);
            Vector3 offset = inverse.MultiplyVector(m.GetColumn(3));
            inverse.m03 = -offset.x;
            inverse.m13 = -offset.y;
            inverse.m23 = -offset.z;
            inverse.m33 = 1f;
            return true;
        }

        /// <summary>Half the edges of the axis-aligned box round the image of one.</summary>
        /// <param name="m">The transform.</param>
        /// <param name="half">Half the edges of the box.</param>
        public static Vector3 Extents(in Matrix4x4 m, Vector3 half) =>
            new Vector3(Extent(m, 0, half), Extent(m, 1, half), Extent(m, 2, half));

        /// <summary>The axis-aligned box round the image of one that is centred on the origin.</summary>
        /// <param name="m">The transform.</param>
        /// <param name="size">Edges of the box.</param>
        public static Bounds BoundsOf(in Matrix4x4 m, Vector3 size) => new Bounds(m.MultiplyPoint3x4(Vector3.zero), Extents(m, size));

        /// <summary>Whether no component is infinite or not a number.</summary>
        public static bool IsFinite(Vector3 v) => IsFinite(v.x) && IsFinite(v.y) && IsFinite(v.z);

        /// <summary>Whether the value is neither infinite nor not a number.</summary>
        public static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

        /// <summary>Whether the numbers are the same, NaN included; == and Equals differ from NaN, == also lets 1e-5 pass.</summary>
        public static bool Same(Vector3 a, Vector3 b) => a.x.Equals(b.x) && a.y.Equals(b.y) && a.z.Equals(b.z);

        private static double Length(in Matrix4x4 m, int column)
        {
            Vector4 c = m.GetColumn(column);
            return Math.Sqrt((double)c.x * c.x + (double)c.y * c.y + (double)c.z * c.z);
        }

        private static float Extent(in Matrix4x4 m, int row, Vector3 half) =>
            Mathf.Abs(m[row, 0]) * half.x + Mathf.Abs(m[row, 1]) * half.y + Mathf.Abs(m[row, 2]) * half.z;

        private static float Cofactor(float a, float b, float c, float d, double scale) =>
            (float)(((double)a * b - (double)c * d) * scale);
    }
}
