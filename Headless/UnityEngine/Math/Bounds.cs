using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Bounds : IEquatable<Bounds>, IFormattable
{
    Vector3 m_Center;
    Vector3 m_Extents;

    public Bounds(Vector3 center, Vector3 size) { m_Center = center; m_Extents = size * 0.5f; }

    public Vector3 center { readonly get => m_Center; set => m_Center = value; }
    public Vector3 extents { readonly get => m_Extents; set => m_Extents = value; }
    public Vector3 size { readonly get => m_Extents * 2f; set => m_Extents = value * 0.5f; }
    public Vector3 min { readonly get => m_Center - m_Extents; set => SetMinMax(value, max); }
    public Vector3 max { readonly get => m_Center + m_Extents; set => SetMinMax(min, value); }

    public void SetMinMax(Vector3 min, Vector3 max)
    {
        m_Extents = (max - min) * 0.5f;
        m_Center = min + m_Extents;
    }

    public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

    public void Encapsulate(Bounds bounds)
    {
        Encapsulate(bounds.m_Center - bounds.m_Extents);
        Encapsulate(bounds.m_Center + bounds.m_Extents);
    }

    public void Expand(float amount) => m_Extents += Vector3.one * (amount * 0.5f);
    public void Expand(Vector3 amount) => m_Extents += amount * 0.5f;

    public bool Intersects(Bounds bounds)
    {
        Vector3 a0 = min, a1 = max, b0 = bounds.min, b1 = bounds.max;
        return a0.x <= b1.x && a1.x >= b0.x && a0.y <= b1.y && a1.y >= b0.y && a0.z <= b1.z && a1.z >= b0.z;
    }

    public bool Contains(Vector3 point)
    {
        Vector3 d = point - m_Center;
        return MathF.Abs(d.x) <= m_Extents.x && MathF.Abs(d.y) <= m_Extents.y && MathF.Abs(d.z) <= m_Extents.z;
    }

    public Vector3 ClosestPoint(Vector3 point) => Vector3.Max(min, Vector3.Min(max, point));
    public float SqrDistance(Vector3 point) => (point - ClosestPoint(point)).sqrMagnitude;
    public bool IntersectRay(Ray ray) => IntersectRay(ray, out _);

    public bool IntersectRay(Ray ray, out float distance)
    {
        float near = float.NegativeInfinity, far = float.PositiveInfinity;
        Vector3 low = min - ray.origin, high = max - ray.origin;
        for (int axis = 0; axis < 3; axis++)
        {
            float direction = ray.direction[axis];
            if (direction == 0f)
            {
                if (low[axis] > 0f || high[axis] < 0f) { distance = 0f; return false; }
                continue;
            }
            float t0 = low[axis] / direction, t1 = high[axis] / direction;
            near = MathF.Max(near, MathF.Min(t0, t1));
            far = MathF.Min(far, MathF.Max(t0, t1));
        }
        bool hit = near <= far && far >= 0f;
        distance = hit ? near : 0f;
        return hit;
    }

    public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.m_Center == rhs.m_Center && lhs.m_Extents == rhs.m_Extents;
    public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);

    public readonly bool Equals(Bounds other) => m_Center.Equals(other.m_Center) && m_Extents.Equals(other.m_Extents);
    public override readonly bool Equals(object? other) => other is Bounds b && Equals(b);
    public override readonly int GetHashCode() => m_Center.GetHashCode() ^ (m_Extents.GetHashCode() << 2);
    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"Center: {m_Center.ToString(format, formatProvider)}, Extents: {m_Extents.ToString(format, formatProvider)}";
}
