namespace UnityEngine;

public partial struct Matrix4x4
{
    public static Matrix4x4 Transpose(Matrix4x4 m) => new(m.GetRow(0), m.GetRow(1), m.GetRow(2), m.GetRow(3));

    public static float Determinant(Matrix4x4 m)
    {
        Minors(m, out double s0, out double s1, out double s2, out double s3, out double s4, out double s5,
            out double c0, out double c1, out double c2, out double c3, out double c4, out double c5);
        return (float)(s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0);
    }

    /// <summary>The inverse, or the zero matrix when there is none.</summary>
    public static Matrix4x4 Inverse(Matrix4x4 m)
    {
        Minors(m, out double s0, out double s1, out double s2, out double s3, out double s4, out double s5,
            out double c0, out double c1, out double c2, out double c3, out double c4, out double c5);
        double det = s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0;
        if (det == 0.0) return zero;
        double d = 1.0 / det;
        return new Matrix4x4
        {
            m00 = (float)((m.m11 * c5 - m.m12 * c4 + m.m13 * c3) * d),
            m01 = (float)((-m.m01 * c5 + m.m02 * c4 - m.m03 * c3) * d),
            m02 = (float)((m.m31 * s5 - m.m32 * s4 + m.m33 * s3) * d),
            m03 = (float)((-m.m21 * s5 + m.m22 * s4 - m.m23 * s3) * d),
            m10 = (float)((-m.m10 * c5 + m.m12 * c2 - m.m13 * c1) * d),
            m11 = (float)((m.m00 * c5 - m.m02 * c2 + m.m03 * c1) * d),
            m12 = (float)((-m.m30 * s5 + m.m32 * s2 - m.m33 * s1) * d),
            m13 = (float)((m.m20 * s5 - m.m22 * s2 + m.m23 * s1) * d),
            m20 = (float)((m.m10 * c4 - m.m11 * c2 + m.m13 * c0) * d),
            m21 = (float)((-m.m00 * c4 + m.m01 * c2 - m.m03 * c0) * d),
            m22 = (float)((m.m30 * s4 - m.m31 * s2 + m.m33 * s0) * d),
            m23 = (float)((-m.m20 * s4 + m.m21 * s2 - m.m23 * s0) * d),
            m30 = (float)((-m.m10 * c3 + m.m11 * c1 - m.m12 * c0) * d),
            m31 = (float)((m.m00 * c3 - m.m01 * c1 + m.m02 * c0) * d),
            m32 = (float)((-m.m30 * s3 + m.m31 * s1 - m.m32 * s0) * d),
            m33 = (float)((m.m20 * s3 - m.m21 * s1 + m.m22 * s0) * d),
        };
    }

    public static bool Inverse3DAffine(Matrix4x4 input, ref Matrix4x4 result)
    {
        Matrix4x4 affine = input;
        affine.SetRow(3, new Vector4(0f, 0f, 0f, 1f));
        Matrix4x4 inverse = Inverse(affine);
        if (inverse.m33 == 0f)
        {
            result = identity;
            return false;
        }
        result = inverse;
        return true;
    }

    // 2 x 2 minors of the upper (s) and lower (c) row pairs: Laplace expansion along two rows.
    static void Minors(in Matrix4x4 m, out double s0, out double s1, out double s2, out double s3, out double s4, out double s5,
        out double c0, out double c1, out double c2, out double c3, out double c4, out double c5)
    {
        s0 = (double)m.m00 * m.m11 - (double)m.m10 * m.m01;
        s1 = (double)m.m00 * m.m12 - (double)m.m10 * m.m02;
        s2 = (double)m.m00 * m.m13 - (double)m.m10 * m.m03;
        s3 = (double)m.m01 * m.m12 - (double)m.m11 * m.m02;
        s4 = (double)m.m01 * m.m13 - (double)m.m11 * m.m03;
        s5 = (double)m.m02 * m.m13 - (double)m.m12 * m.m03;
        c0 = (double)m.m20 * m.m31 - (double)m.m30 * m.m21;
        c1 = (double)m.m20 * m.m32 - (double)m.m30 * m.m22;
        c2 = (double)m.m20 * m.m33 - (double)m.m30 * m.m23;
        c3 = (double)m.m21 * m.m32 - (double)m.m31 * m.m22;
        c4 = (double)m.m21 * m.m33 - (double)m.m31 * m.m23;
        c5 = (double)m.m22 * m.m33 - (double)m.m32 * m.m23;
    }
}
