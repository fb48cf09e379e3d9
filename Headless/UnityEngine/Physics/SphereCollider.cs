using Headless.Engine;

namespace UnityEngine;

public class SphereCollider : Collider
{
    public Vector3 center { get; set; }
    public float radius { get; set; } = 0.5f;

    Vector3 WorldCenter => Pose.LocalToWorld.MultiplyPoint3x4(center);

    // The largest axis of the scale counts.
    float WorldRadius
    {
        get
        {
            Vector3 scale = Pose.AbsoluteScale;
            return Mathf.Abs(radius) * Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z));
        }
    }

    internal override bool HasShape => true;
    internal override Bounds WorldBounds => new(WorldCenter, Vector3.one * (2f * WorldRadius));
    internal override bool OverlapsBox(in PhysicsBox box) => (box.ClosestPoint(WorldCenter) - WorldCenter).sqrMagnitude <= WorldRadius * WorldRadius;

    internal override bool OverlapsSphere(Vector3 center, float radius)
    {
        float reach = radius + WorldRadius;
        return (center - WorldCenter).sqrMagnitude <= reach * reach;
    }

    internal override void MeetRay(ref PhysicsRay ray) => ray.MeetSphere(WorldCenter, WorldRadius);

    internal override Vector3 ClosestPointCore(Vector3 position)
    {
        Vector3 offset = position - WorldCenter;
        return offset.magnitude <= WorldRadius ? position : WorldCenter + offset.normalized * WorldRadius;
    }

    internal override void FitToMesh()
    {
        if (ColliderFit.MeshBounds(this) is not { } bounds) return;
        center = bounds.center;
        radius = Mathf.Max(bounds.extents.x, Mathf.Max(bounds.extents.y, bounds.extents.z));
    }
}
