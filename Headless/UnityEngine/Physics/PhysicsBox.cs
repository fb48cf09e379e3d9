using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A box, or parallelepiped, by its centre and three half edges.</summary>
readonly struct PhysicsBox
{
    public readonly Vector3 Center;
    public readonly Vector3 X;
    public readonly Vector3 Y;
    public readonly Vector3 Z;

    PhysicsBox(Vector3 center, Vector3 x, Vector3 y, Vector3 z) { Center = center; X = x; Y = y; Z = z; }

    public static PhysicsBox Oriented(Vector3 center, Vector3 halfExtents, Quaternion rotation) =>
        new(center, rotation * new Vector3(halfExtents.x, 0f, 0f), rotation * new Vector3(0f, halfExtents.y, 0f), rotation * new Vector3(0f, 0f, halfExtents.z));

    public static PhysicsBox Transformed(Bounds local, Matrix4x4 matrix) => new(
        matrix.MultiplyPoint3x4(local.center),
        matrix.MultiplyVector(new Vector3(local.extents.x, 0f, 0f)),
        matrix.MultiplyVector(new Vector3(0f, local.extents.y, 0f)),
        matrix.MultiplyVector(new Vector3(0f, 0f, local.extents.z)));

    public Bounds Bounds
    {
        get
        {
            var extents = new Vector3(
                MathF.Abs(X.x) + MathF.Abs(Y.x) + MathF.Abs(Z.x),
                MathF.Abs(X.y) + MathF.Abs(Y.y) + MathF.Abs(Z.y),
                MathF.Abs(X.z) + MathF.Abs(Y.z) + MathF.Abs(Z.z));
            return new Bounds(Center, extents * 2f);
        }
    }

    /// <summary>Separating axes: face normals of both and cross products of their edges (S. Gottschalk 1996).</summary>
    public bool Intersects(in PhysicsBox other)
    {
        Span<Vector3> a = [X, Y, Z];
        Span<Vector3> b = [other.X, other.Y, other.Z];
        for (int i = 0; i < 3; i++)
        {
            if (Separates(Vector3.Cross(a[(i + 1) % 3], a[(i + 2) % 3]), other)) return false;
            if (Separates(Vector3.Cross(b[(i + 1) % 3], b[(i + 2) % 3]), other)) return false;
            for (int j = 0; j < 3; j++)
                if (Separates(Vector3.Cross(a[i], b[j]), other)) return false;
        }
        return true;
    }

    bool Separates(Vector3 axis, in PhysicsBox other)
    {
        float length = axis.magnitude;
        if (length < 1e-12f) return false;
        axis /= length;
        return MathF.Abs(Vector3.Dot(axis, other.Center - Center)) > Reach(axis) + other.Reach(axis);
    }

    float Reach(Vector3 axis) => MathF.Abs(Vector3.Dot(axis, X)) + MathF.Abs(Vector3.Dot(axis, Y)) + MathF.Abs(Vector3.Dot(axis, Z));

    /// <summary>Nearest point of a box with right angles; the point itself when it is inside.</summary>
    public Vector3 ClosestPoint(Vector3 point)
    {
        Vector3 offset = point - Center;
        Vector3 nearest = Center + Along(offset, X) + Along(offset, Y) + Along(offset, Z);
        bool inside = Inside(offset, X) && Inside(offset, Y) && Inside(offset, Z);
        return inside ? point : nearest;
    }

    /// <summary>From a point inside the shortest way out of a box with right angles: direction and distance.</summary>
    public (Vector3 normal, float distance) WayOut(Vector3 point)
    {
        Vector3 normal = Vector3.up;
        float least = float.PositiveInfinity;
        foreach (Vector3 halfEdge in (ReadOnlySpan<Vector3>)[X, Y, Z])
        {
            float length = halfEdge.magnitude, along = length > 0f ? Vector3.Dot(point - Center, halfEdge) / length : 0f;
            if (length - MathF.Abs(along) >= least) continue;
            least = length - MathF.Abs(along);
            normal = halfEdge / MathF.Max(length, 1e-30f) * (along < 0f ? -1f : 1f);
        }
        return (normal, least);
    }

    static Vector3 Along(Vector3 offset, Vector3 halfEdge)
    {
        float square = halfEdge.sqrMagnitude;
        return square == 0f ? Vector3.zero : halfEdge * Mathf.Clamp(Vector3.Dot(offset, halfEdge) / square, -1f, 1f);
    }

    static bool Inside(Vector3 offset, Vector3 halfEdge) => MathF.Abs(Vector3.Dot(offset, halfEdge)) <= halfEdge.sqrMagnitude;

    /// <summary>Distance to a segment. Distance to a convex set is convex along a line, so a ternary search finds it.</summary>
    public float DistanceToSegment(Vector3 a, Vector3 b)
    {
        float low = 0f, high = 1f;
        for (int i = 0; i < 60; i++)
        {
            float t0 = low + (high - low) / 3f, t1 = high - (high - low) / 3f;
            if (SquaredDistance(Vector3.Lerp(a, b, t0)) <= SquaredDistance(Vector3.Lerp(a, b, t1))) high = t1;
            else low = t0;
        }
        return MathF.Sqrt(SquaredDistance(Vector3.Lerp(a, b, 0.5f * (low + high))));
    }

    float SquaredDistance(Vector3 point) => (point - ClosestPoint(point)).sqrMagnitude;
}
