using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Vector2 : IEquatable<Vector2>, IFormattable
{
    public const float kEpsilon = 0.00001f;
    public const float kEpsilonNormalSqrt = 1e-15f;

    public float x;
    public float y;

    public Vector2(float x, float y) { this.x = x; this.y = y; }

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, _ => throw new IndexOutOfRangeException("Invalid Vector2 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector2 index!");
            }
        }
    }

    public static Vector2 zero => new(0f, 0f);
    public static Vector2 one => new(1f, 1f);
    public static Vector2 up => new(0f, 1f);
    public static Vector2 down => new(0f, -1f);
    public static Vector2 left => new(-1f, 0f);
    public static Vector2 right => new(1f, 0f);
    public static Vector2 positiveInfinity => new(float.PositiveInfinity, float.PositiveInfinity);
    public static Vector2 negativeInfinity => new(float.NegativeInfinity, float.NegativeInfinity);

    public float magnitude => MathF.Sqrt(x * x + y * y);
    public float sqrMagnitude => x * x + y * y;
    public Vector2 normalized { get { var v = this; v.Normalize(); return v; } }

    public void Set(float newX, float newY) { x = newX; y = newY; }
    public void Scale(Vector2 scale) { x *= scale.x; y *= scale.y; }
    public float SqrMagnitude() => sqrMagnitude;

    public void Normalize()
    {
        float length = magnitude;
        this = length > kEpsilon ? this / length : zero;
    }

    public static Vector2 Scale(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static float Dot(Vector2 lhs, Vector2 rhs) => lhs.x * rhs.x + lhs.y * rhs.y;
    public static float Distance(Vector2 a, Vector2 b) => (a - b).magnitude;
    public static float SqrMagnitude(Vector2 a) => a.sqrMagnitude;
    public static Vector2 Min(Vector2 lhs, Vector2 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y));
    public static Vector2 Max(Vector2 lhs, Vector2 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y));
    public static Vector2 Lerp(Vector2 a, Vector2 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Vector2 LerpUnclamped(Vector2 a, Vector2 b, float t) => a + (b - a) * t;
    public static Vector2 Perpendicular(Vector2 inDirection) => new(-inDirection.y, inDirection.x);
    public static Vector2 Reflect(Vector2 inDirection, Vector2 inNormal) => inDirection - 2f * Dot(inNormal, inDirection) * inNormal;

    public static Vector2 MoveTowards(Vector2 current, Vector2 target, float maxDistanceDelta)
    {
        Vector2 to = target - current;
        float distance = to.magnitude;
        return distance == 0f || (maxDistanceDelta >= 0f && distance <= maxDistanceDelta) ? target : current + to / distance * maxDistanceDelta;
    }

    public static Vector2 ClampMagnitude(Vector2 vector, float maxLength)
    {
        float length = vector.magnitude;
        return length > maxLength ? vector / length * maxLength : vector;
    }

    public static float Angle(Vector2 from, Vector2 to)
    {
        float denominator = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return denominator < kEpsilonNormalSqrt ? 0f : MathF.Acos(Mathf.Clamp(Dot(from, to) / denominator, -1f, 1f)) * Mathf.Rad2Deg;
    }

    public static float SignedAngle(Vector2 from, Vector2 to) => Angle(from, to) * Mathf.Sign(from.x * to.y - from.y * to.x);

    public static Vector2 SmoothDamp(Vector2 current, Vector2 target, ref Vector2 currentVelocity, float smoothTime) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, Mathf.Infinity, Time.deltaTime);

    public static Vector2 SmoothDamp(Vector2 current, Vector2 target, ref Vector2 currentVelocity, float smoothTime, float maxSpeed) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

    public static Vector2 SmoothDamp(Vector2 current, Vector2 target, ref Vector2 currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
    {
        Vector3 velocity = currentVelocity;
        Vector2 result = Vector3.SmoothDamp(current, target, ref velocity, smoothTime, maxSpeed, deltaTime);
        currentVelocity = velocity;
        return result;
    }

    public static Vector2 operator +(Vector2 a, Vector2 b) => new(a.x + b.x, a.y + b.y);
    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.x - b.x, a.y - b.y);
    public static Vector2 operator *(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static Vector2 operator /(Vector2 a, Vector2 b) => new(a.x / b.x, a.y / b.y);
    public static Vector2 operator -(Vector2 a) => new(-a.x, -a.y);
    public static Vector2 operator *(Vector2 a, float d) => new(a.x * d, a.y * d);
    public static Vector2 operator *(float d, Vector2 a) => new(a.x * d, a.y * d);
    public static Vector2 operator /(Vector2 a, float d) => new(a.x / d, a.y / d);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector2(Vector3 v) => new(v.x, v.y);
    public static implicit operator Vector3(Vector2 v) => new(v.x, v.y, 0f);

    public readonly bool Equals(Vector2 other) => x == other.x && y == other.y;
    public override readonly bool Equals(object? other) => other is Vector2 v && Equals(v);
    public override readonly int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2);
    public override readonly string ToString() => Formatting.Tuple(null, null, x, y);
    public readonly string ToString(string? format) => Formatting.Tuple(format, null, x, y);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) => Formatting.Tuple(format, formatProvider, x, y);
}
