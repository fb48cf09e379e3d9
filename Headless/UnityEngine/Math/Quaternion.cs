using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public partial struct Quaternion : IEquatable<Quaternion>, IFormattable
{
    public const float kEpsilon = 0.000001f;

    public float x;
    public float y;
    public float z;
    public float w;

    public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Quaternion index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                case 3: w = value; break;
                default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
            }
        }
    }

    public static Quaternion identity => new(0f, 0f, 0f, 1f);
    public Quaternion normalized => Normalize(this);

    public Vector3 eulerAngles
    {
        get => ToEulerDegrees(this);
        set => this = Euler(value);
    }

    public void Set(float newX, float newY, float newZ, float newW) { x = newX; y = newY; z = newZ; w = newW; }
    public void Normalize() => this = Normalize(this);

    public static Quaternion Normalize(Quaternion q)
    {
        float length = MathF.Sqrt(Dot(q, q));
        return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
    }

    public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

    public static Quaternion Inverse(Quaternion rotation)
    {
        float square = Dot(rotation, rotation);
        return square < Mathf.Epsilon ? rotation : new Quaternion(-rotation.x / square, -rotation.y / square, -rotation.z / square, rotation.w / square);
    }

    public static float Angle(Quaternion a, Quaternion b)
    {
        float dot = Mathf.Min(MathF.Abs(Dot(a, b)), 1f);
        return dot > 1f - kEpsilon ? 0f : MathF.Acos(dot) * 2f * Mathf.Rad2Deg;
    }

    public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new(
        lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
        lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
        lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
        lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        float x = rotation.x * 2f, y = rotation.y * 2f, z = rotation.z * 2f;
        float xx = rotation.x * x, yy = rotation.y * y, zz = rotation.z * z;
        float xy = rotation.x * y, xz = rotation.x * z, yz = rotation.y * z;
        float wx = rotation.w * x, wy = rotation.w * y, wz = rotation.w * z;
        return new Vector3(
            (1f - (yy + zz)) * point.x + (xy - wz) * point.y + (xz + wy) * point.z,
            (xy + wz) * point.x + (1f - (xx + zz)) * point.y + (yz - wx) * point.z,
            (xz - wy) * point.x + (yz + wx) * point.y + (1f - (xx + yy)) * point.z);
    }

    public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1f - kEpsilon;
    public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

    public readonly bool Equals(Quaternion other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);
    public override readonly bool Equals(object? other) => other is Quaternion q && Equals(q);
    public override readonly int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2) ^ (w.GetHashCode() >> 1);
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        Formatting.Tuple(string.IsNullOrEmpty(format) ? "F5" : format, formatProvider, x, y, z, w);
}
