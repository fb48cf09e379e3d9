using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A ray of unit direction and the first hit on it so far. What it starts inside is not hit, as Unity documents.</summary>
struct PhysicsRay(Vector3 origin, Vector3 direction, float reach)
{
    const float Parallel = 1e-12f;
    const float Edge = 1e-5f; // of a triangle: rays meet edges that two share

    /// <summary>Distance of the nearest hit so far; the reach before there is one.</summary>
    public float Distance { get; private set; } = reach;

    public Vector3 Normal { get; private set; }

    public bool IsHit { get; private set; }

    public readonly Vector3 Point => origin + direction * Distance;

    /// <summary>A box with right angles.</summary>
    public void MeetBox(in PhysicsBox box)
    {
        float enter = float.NegativeInfinity, leave = float.PositiveInfinity;
        Vector3 normal = default;
        foreach (Vector3 halfEdge in (ReadOnlySpan<Vector3>)[box.X, box.Y, box.Z])
        {
            float length = halfEdge.magnitude;
            if (length == 0f) return; // a box without thickness is none
            Vector3 axis = halfEdge / length;
            float along = Vector3.Dot(direction, axis), offset = Vector3.Dot(box.Center - origin, axis);
            if (MathF.Abs(along) < Parallel)
            {
                if (MathF.Abs(offset) > length) return;
                continue;
            }
            float near = (offset - MathF.Sign(along) * length) / along, far = (offset + MathF.Sign(along) * length) / along;
            if (near > enter) (enter, normal) = (near, -MathF.Sign(along) * axis);
            leave = MathF.Min(leave, far);
        }
        if (enter >= 0f && enter <= leave) Take(enter, normal);
    }

    public void MeetSphere(Vector3 center, float radius)
    {
        Vector3 offset = origin - center;
        float middle = -Vector3.Dot(offset, direction), inside = middle * middle - (offset.sqrMagnitude - radius * radius);
        if (inside < 0f || offset.sqrMagnitude <= radius * radius) return;
        float distance = middle - MathF.Sqrt(inside);
        if (distance >= 0f) Take(distance, (origin + direction * distance - center) / radius);
    }

    /// <summary>Its side, between the end points, and its two half spheres.</summary>
    public void MeetCapsule(in PhysicsCapsule capsule)
    {
        if ((capsule.ClosestPoint(origin) - origin).sqrMagnitude == 0f) return;
        MeetSphere(capsule.Center - capsule.HalfAxis, capsule.Radius);
        MeetSphere(capsule.Center + capsule.HalfAxis, capsule.Radius);
        float half = capsule.HalfAxis.magnitude;
        if (half == 0f) return;
        Vector3 axis = capsule.HalfAxis / half, offset = origin - capsule.Center;
        Vector3 across = direction - axis * Vector3.Dot(direction, axis), from = offset - axis * Vector3.Dot(offset, axis);
        float a = across.sqrMagnitude, b = Vector3.Dot(from, across), c = from.sqrMagnitude - capsule.Radius * capsule.Radius;
        if (a < Parallel || b * b < a * c) return;
        float distance = (-b - MathF.Sqrt(b * b - a * c)) / a;
        if (distance < 0f || MathF.Abs(Vector3.Dot(offset + direction * distance, axis)) > half) return;
        Take(distance, (from + across * distance) / capsule.Radius);
    }

    /// <summary>A triangle, clockwise as seen from its front; the back only where the query asks for it.</summary>
    public void MeetTriangle(Vector3 a, Vector3 b, Vector3 c, bool backfaces)
    {
        // T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
        Vector3 ab = b - a, ac = c - a, p = Vector3.Cross(direction, ac);
        float determinant = Vector3.Dot(ab, p);
        if (determinant == 0f || determinant < 0f && !backfaces) return;
        Vector3 offset = origin - a, q = Vector3.Cross(offset, ab);
        float u = Vector3.Dot(offset, p) / determinant, v = Vector3.Dot(direction, q) / determinant;
        float distance = Vector3.Dot(ac, q) / determinant;
        if (!(u >= -Edge && v >= -Edge && u + v <= 1f + Edge && distance >= 0f)) return;
        Take(distance, MathF.Sign(determinant) * Vector3.Cross(ab, ac).normalized);
    }

    void Take(float distance, Vector3 normal)
    {
        if (distance > Distance || IsHit && distance == Distance) return;
        (Distance, Normal, IsHit) = (distance, normal, true);
    }
}
