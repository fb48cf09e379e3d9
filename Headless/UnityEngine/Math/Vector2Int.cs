using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Vector2Int : IEquatable<Vector2Int>, IFormattable
{
    int m_X;
    int m_Y;

    public Vector2Int(int x, int y) { m_X = x; m_Y = y; }

    public int x { readonly get => m_X; set => m_X = value; }
    public int y { readonly get => m_Y; set => m_Y = value; }

    public int this[int index]
    {
        readonly get => index switch { 0 => m_X, 1 => m_Y, _ => throw new IndexOutOfRangeException($"Invalid Vector2Int index addressed: {index}!") };
        set
        {
            switch (index)
            {
                case 0: m_X = value; break;
                case 1: m_Y = value; break;
                default: throw new IndexOutOfRangeException($"Invalid Vector2Int index addressed: {index}!");
            }
        }
    }

    public static Vector2Int zero => new(0, 0);
    public static Vector2Int one => new(1, 1);
    public static Vector2Int up => new(0, 1);
    public static Vector2Int down => new(0, -1);
    public static Vector2Int left => new(-1, 0);
    public static Vector2Int right => new(1, 0);

    public float magnitude => MathF.Sqrt(sqrMagnitude);
    public int sqrMagnitude => m_X * m_X + m_Y * m_Y;

    public void Set(int x, int y) { m_X = x; m_Y = y; }
    public void Scale(Vector2Int scale) { m_X *= scale.m_X; m_Y *= scale.m_Y; }

    public void Clamp(Vector2Int min, Vector2Int max)
    {
        m_X = Math.Min(max.m_X, Math.Max(min.m_X, m_X));
        m_Y = Math.Min(max.m_Y, Math.Max(min.m_Y, m_Y));
    }

    public static Vector2Int Scale(Vector2Int a, Vector2Int b) => new(a.m_X * b.m_X, a.m_Y * b.m_Y);
    public static Vector2Int Min(Vector2Int lhs, Vector2Int rhs) => new(Math.Min(lhs.m_X, rhs.m_X), Math.Min(lhs.m_Y, rhs.m_Y));
    public static Vector2Int Max(Vector2Int lhs, Vector2Int rhs) => new(Math.Max(lhs.m_X, rhs.m_X), Math.Max(lhs.m_Y, rhs.m_Y));
    public static float Distance(Vector2Int a, Vector2Int b) => (a - b).magnitude;
    public static Vector2Int FloorToInt(Vector2 v) => new(Mathf.FloorToInt(v.x), Mathf.FloorToInt(v.y));
    public static Vector2Int CeilToInt(Vector2 v) => new(Mathf.CeilToInt(v.x), Mathf.CeilToInt(v.y));
    public static Vector2Int RoundToInt(Vector2 v) => new(Mathf.RoundToInt(v.x), Mathf.RoundToInt(v.y));

    public static Vector2Int operator +(Vector2Int a, Vector2Int b) => new(a.m_X + b.m_X, a.m_Y + b.m_Y);
    public static Vector2Int operator -(Vector2Int a, Vector2Int b) => new(a.m_X - b.m_X, a.m_Y - b.m_Y);
    public static Vector2Int operator *(Vector2Int a, Vector2Int b) => new(a.m_X * b.m_X, a.m_Y * b.m_Y);
    public static Vector2Int operator -(Vector2Int v) => new(-v.m_X, -v.m_Y);
    public static Vector2Int operator *(int a, Vector2Int b) => new(a * b.m_X, a * b.m_Y);
    public static Vector2Int operator *(Vector2Int a, int b) => new(a.m_X * b, a.m_Y * b);
    public static Vector2Int operator /(Vector2Int a, int b) => new(a.m_X / b, a.m_Y / b);
    public static bool operator ==(Vector2Int lhs, Vector2Int rhs) => lhs.Equals(rhs);
    public static bool operator !=(Vector2Int lhs, Vector2Int rhs) => !lhs.Equals(rhs);
    public static implicit operator Vector2(Vector2Int v) => new(v.m_X, v.m_Y);
    public static explicit operator Vector3Int(Vector2Int v) => new(v.m_X, v.m_Y, 0);

    public readonly bool Equals(Vector2Int other) => m_X == other.m_X && m_Y == other.m_Y;
    public override readonly bool Equals(object? other) => other is Vector2Int v && Equals(v);
    public override readonly int GetHashCode() => (m_X * 73856093) ^ (m_Y * 83492791);
    public override readonly string ToString() => Formatting.Tuple(null, null, m_X, m_Y);
    public readonly string ToString(string? format) => Formatting.Tuple(format, null, m_X, m_Y);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) => Formatting.Tuple(format, formatProvider, m_X, m_Y);
}
