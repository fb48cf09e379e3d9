using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Vector3Int : IEquatable<Vector3Int>, IFormattable
{
    int m_X;
    int m_Y;
    int m_Z;

    public Vector3Int(int x, int y, int z) { m_X = x; m_Y = y; m_Z = z; }
    public Vector3Int(int x, int y) : this(x, y, 0) { }

    public int x { readonly get => m_X; set => m_X = value; }
    public int y { readonly get => m_Y; set => m_Y = value; }
    public int z { readonly get => m_Z; set => m_Z = value; }

    public int this[int index]
    {
        readonly get => index switch { 0 => m_X, 1 => m_Y, 2 => m_Z, _ => throw new IndexOutOfRangeException($"Invalid Vector3Int index addressed: {index}!") };
        set
        {
            switch (index)
            {
                case 0: m_X = value; break;
                case 1: m_Y = value; break;
                case 2: m_Z = value; break;
                default: throw new IndexOutOfRangeException($"Invalid Vector3Int index addressed: {index}!");
            }
        }
    }

    public static Vector3Int zero => new(0, 0, 0);
    public static Vector3Int one => new(1, 1, 1);
    public static Vector3Int up => new(0, 1, 0);
    public static Vector3Int down => new(0, -1, 0);
    public static Vector3Int left => new(-1, 0, 0);
    public static Vector3Int right => new(1, 0, 0);
    public static Vector3Int forward => new(0, 0, 1);
    public static Vector3Int back => new(0, 0, -1);

    public float magnitude => MathF.Sqrt(sqrMagnitude);
    public int sqrMagnitude => m_X * m_X + m_Y * m_Y + m_Z * m_Z;

    public void Set(int x, int y, int z) { m_X = x; m_Y = y; m_Z = z; }
    public void Scale(Vector3Int scale) { m_X *= scale.m_X; m_Y *= scale.m_Y; m_Z *= scale.m_Z; }

    public void Clamp(Vector3Int min, Vector3Int max)
    {
        m_X = Math.Min(max.m_X, Math.Max(min.m_X, m_X));
        m_Y = Math.Min(max.m_Y, Math.Max(min.m_Y, m_Y));
        m_Z = Math.Min(max.m_Z, Math.Max(min.m_Z, m_Z));
    }

    public static Vector3Int Scale(Vector3Int a, Vector3Int b) => new(a.m_X * b.m_X, a.m_Y * b.m_Y, a.m_Z * b.m_Z);
    public static Vector3Int Min(Vector3Int lhs, Vector3Int rhs) => new(Math.Min(lhs.m_X, rhs.m_X), Math.Min(lhs.m_Y, rhs.m_Y), Math.Min(lhs.m_Z, rhs.m_Z));
    public static Vector3Int Max(Vector3Int lhs, Vector3Int rhs) => new(Math.Max(lhs.m_X, rhs.m_X), Math.Max(lhs.m_Y, rhs.m_Y), Math.Max(lhs.m_Z, rhs.m_Z));
    public static float Distance(Vector3Int a, Vector3Int b) => (a - b).magnitude;
    public static Vector3Int FloorToInt(Vector3 v) => new(Mathf.FloorToInt(v.x), Mathf.FloorToInt(v.y), Mathf.FloorToInt(v.z));
    public static Vector3Int CeilToInt(Vector3 v) => new(Mathf.CeilToInt(v.x), Mathf.CeilToInt(v.y), Mathf.CeilToInt(v.z));
    public static Vector3Int RoundToInt(Vector3 v) => new(Mathf.RoundToInt(v.x), Mathf.RoundToInt(v.y), Mathf.RoundToInt(v.z));

    public static Vector3Int operator +(Vector3Int a, Vector3Int b) => new(a.m_X + b.m_X, a.m_Y + b.m_Y, a.m_Z + b.m_Z);
    public static Vector3Int operator -(Vector3Int a, Vector3Int b) => new(a.m_X - b.m_X, a.m_Y - b.m_Y, a.m_Z - b.m_Z);
    public static Vector3Int operator *(Vector3Int a, Vector3Int b) => new(a.m_X * b.m_X, a.m_Y * b.m_Y, a.m_Z * b.m_Z);
    public static Vector3Int operator -(Vector3Int a) => new(-a.m_X, -a.m_Y, -a.m_Z);
    public static Vector3Int operator *(Vector3Int a, int b) => new(a.m_X * b, a.m_Y * b, a.m_Z * b);
    public static Vector3Int operator *(int a, Vector3Int b) => new(a * b.m_X, a * b.m_Y, a * b.m_Z);
    public static Vector3Int operator /(Vector3Int a, int b) => new(a.m_X / b, a.m_Y / b, a.m_Z / b);
    public static bool operator ==(Vector3Int lhs, Vector3Int rhs) => lhs.Equals(rhs);
    public static bool operator !=(Vector3Int lhs, Vector3Int rhs) => !lhs.Equals(rhs);
    public static implicit operator Vector3(Vector3Int v) => new(v.m_X, v.m_Y, v.m_Z);
    public static explicit operator Vector2Int(Vector3Int v) => new(v.m_X, v.m_Y);

    public readonly bool Equals(Vector3Int other) => m_X == other.m_X && m_Y == other.m_Y && m_Z == other.m_Z;
    public override readonly bool Equals(object? other) => other is Vector3Int v && Equals(v);
    public override readonly int GetHashCode() => HashCode.Combine(m_X, m_Y, m_Z);
    public override readonly string ToString() => Formatting.Tuple(null, null, m_X, m_Y, m_Z);
    public readonly string ToString(string? format) => Formatting.Tuple(format, null, m_X, m_Y, m_Z);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) => Formatting.Tuple(format, formatProvider, m_X, m_Y, m_Z);
}
