using UnityEngine;

namespace Headless.Engine;

/// <summary>All points within a radius of a segment: the shape of capsules and character controllers in world space.</summary>
readonly record struct PhysicsCapsule(Vector3 Center, Vector3 HalfAxis, float Radius)
{
    public Bounds Bounds
    {
        get
        {
            var extents = new Vector3(Mathf.Abs(HalfAxis.x), Mathf.Abs(HalfAxis.y), Mathf.Abs(HalfAxis.z)) + Vector3.one * Radius;
            return new Bounds(Center, extents * 2f);
        }
    }

    public bool Overlaps(in PhysicsBox box) => box.DistanceToSegment(Center - HalfAxis, Center + HalfAxis) <= Radius;
    public bool OverlapsSphere(Vector3 center, float radius) => (NearestOnAxis(center) - center).magnitude <= radius + Radius;

    public Vector3 ClosestPoint(Vector3 position)
    {
        Vector3 onAxis = NearestOnAxis(position);
        Vector3 offset = position - onAxis;
        return offset.magnitude <= Radius ? position : onAxis + offset.normalized * Radius;
    }

    Vector3 NearestOnAxis(Vector3 point)
    {
        float square = HalfAxis.sqrMagnitude;
        return square == 0f ? Center : Center + HalfAxis * Mathf.Clamp(Vector3.Dot(point - Center, HalfAxis) / square, -1f, 1f);
    }
}
