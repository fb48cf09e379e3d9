using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public partial struct Vector3 : IEquatable<Vector3>, IFormattable
{
    public const float kEpsilon = 0.00001f;
    public const float kEpsilonNormalSqrt = 1e-15f;

    public float x;
    public float y;
    public float z;

    public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    public Vector3(float x, float y) { this.x = x; this.y = y; z = 0f; }

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
            }
        }
    }

    public static Vector3 zero => new(0f, 0f, 0f);
    public static Vector3 one => new(1f, 1f, 1f);
    public static Vector3 forward => new(0f, 0f, 1f);
    public static Vector3 back => new(0f, 0f, -1f);
    public static Vector3 up => new(0f, 1f, 0f);
    public static Vector3 down => new(0f, -1f, 0f);
    public static Vector3 left => new(-1f, 0f, 0f);
    public static Vector3 right => new(1f, 0f, 0f);
    public static Vector3 positiveInfinity => new(float.PositiveInfinity, float.PositiveInfinity, float.PositiveInfinity);
    public static Vector3 negativeInfinity => new(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);

    public float magnitude => MathF.Sqrt(x * x + y * y + z * z);
    public float sqrMagnitude => x * x + y * y + z * z;
    public Vector3 normalized => Normalize(this);

    public void Set(float newX, float newY, float newZ) { x = newX; y = newY; z = newZ; }
    public void Scale(Vector3 scale) { x *= scale.x; y *= scale.y; z *= scale.z; }
    public void Normalize() => this = Normalize(this);

    public static Vector3 Normalize(Vector3 value)
    {
        float length = value.magnitude;
        return length > kEpsilon ? value / length : zero;
    }

    public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);
    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
    public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;
    public static float Magnitude(Vector3 vector) => vector.magnitude;
    public static float SqrMagnitude(Vector3 vector) => vector.sqrMagnitude;

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);

    public static Vector3 Min(Vector3 lhs, Vector3 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));
    public static Vector3 Max(Vector3 lhs, Vector3 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));
    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t) => new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);
    public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator *(float d, Vector3 a) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);
    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

    public readonly bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
    public override readonly bool Equals(object? other) => other is Vector3 v && Equals(v);
    public override readonly int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2);
    public override readonly string ToString() => Formatting.Tuple(null, null, x, y, z);
    public readonly string ToString(string? format) => Formatting.Tuple(format, null, x, y, z);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) => Formatting.Tuple(format, formatProvider, x, y, z);
}
