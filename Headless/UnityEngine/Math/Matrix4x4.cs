using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

/// <summary>Column-major in memory; mRC is row R, column C; vectors multiply from the right.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
{
    public float m00, m10, m20, m30;
    public float m01, m11, m21, m31;
    public float m02, m12, m22, m32;
    public float m03, m13, m23, m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
        m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
        m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
        m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
    }

    public float this[int row, int column]
    {
        get => this[row + column * 4];
        set => this[row + column * 4] = value;
    }

    public float this[int index]
    {
        get => (uint)index < 16u ? Components(ref this)[index] : throw new IndexOutOfRangeException("Invalid matrix index!");
        set
        {
            if ((uint)index >= 16u) throw new IndexOutOfRangeException("Invalid matrix index!");
            Components(ref this)[index] = value;
        }
    }

    static Span<float> Components(ref Matrix4x4 m) => MemoryMarshal.CreateSpan(ref m.m00, 16);

    public static Matrix4x4 zero => default;
    public static Matrix4x4 identity => new() { m00 = 1f, m11 = 1f, m22 = 1f, m33 = 1f };
    public bool isIdentity => Equals(identity);
    public float determinant => Determinant(this);
    public Matrix4x4 inverse => Inverse(this);
    public Matrix4x4 transpose => Transpose(this);

    public Vector4 GetColumn(int index) => index switch
    {
        0 => new Vector4(m00, m10, m20, m30),
        1 => new Vector4(m01, m11, m21, m31),
        2 => new Vector4(m02, m12, m22, m32),
        3 => new Vector4(m03, m13, m23, m33),
        _ => throw new IndexOutOfRangeException("Invalid column index!"),
    };

    public Vector4 GetRow(int index) => index switch
    {
        0 => new Vector4(m00, m01, m02, m03),
        1 => new Vector4(m10, m11, m12, m13),
        2 => new Vector4(m20, m21, m22, m23),
        3 => new Vector4(m30, m31, m32, m33),
        _ => throw new IndexOutOfRangeException("Invalid row index!"),
    };

    public void SetColumn(int index, Vector4 column)
    {
        for (int row = 0; row < 4; row++) this[row, index] = column[row];
    }

    public void SetRow(int index, Vector4 row)
    {
        for (int column = 0; column < 4; column++) this[index, column] = row[column];
    }

    public Vector3 GetPosition() => new(m03, m13, m23);

    public Vector3 MultiplyPoint3x4(Vector3 point) => new(
        m00 * point.x + m01 * point.y + m02 * point.z + m03,
        m10 * point.x + m11 * point.y + m12 * point.z + m13,
        m20 * point.x + m21 * point.y + m22 * point.z + m23);

    public Vector3 MultiplyPoint(Vector3 point)
    {
        float w = 1f / (m30 * point.x + m31 * point.y + m32 * point.z + m33);
        return MultiplyPoint3x4(point) * w;
    }

    public Vector3 MultiplyVector(Vector3 vector) => new(
        m00 * vector.x + m01 * vector.y + m02 * vector.z,
        m10 * vector.x + m11 * vector.y + m12 * vector.z,
        m20 * vector.x + m21 * vector.y + m22 * vector.z);

    public Plane TransformPlane(Plane plane)
    {
        Matrix4x4 t = Transpose(Inverse(this));
        Vector4 v = t * new Vector4(plane.normal.x, plane.normal.y, plane.normal.z, plane.distance);
        return new Plane { normal = new Vector3(v.x, v.y, v.z), distance = v.w };
    }

    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) =>
        new(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new(
        lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
        lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
        lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
        lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs)
    {
        for (int i = 0; i < 4; i++) if (lhs.GetColumn(i) != rhs.GetColumn(i)) return false;
        return true;
    }

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

    public bool Equals(Matrix4x4 other) => Components(ref this).SequenceEqual(Components(ref other));
    public override bool Equals(object? other) => other is Matrix4x4 m && Equals(m);

    public override int GetHashCode() =>
        GetColumn(0).GetHashCode() ^ (GetColumn(1).GetHashCode() << 2) ^ (GetColumn(2).GetHashCode() >> 2) ^ (GetColumn(3).GetHashCode() >> 1);

    public override string ToString() => ToString(null, null);
    public string ToString(string? format) => ToString(format, null);

    public string ToString(string? format, IFormatProvider? formatProvider)
    {
        if (string.IsNullOrEmpty(format)) format = "F5";
        formatProvider ??= System.Globalization.CultureInfo.InvariantCulture.NumberFormat;
        var text = new System.Text.StringBuilder();
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                text.Append(this[row, column].ToString(format, formatProvider)).Append(column < 3 ? '\t' : '\n');
        return text.ToString();
    }
}
