using Headless.Engine;

namespace UnityEngine;

public class CapsuleCollider : Collider
{
    public Vector3 center { get; set; }
    public float radius { get; set; } = 0.5f;
    public float height { get; set; } = 1f;

    /// <summary>0, 1, 2: along x, y, z.</summary>
    public int direction { get; set; } = 1;

    Vector3 WorldCenter => Pose.LocalToWorld.MultiplyPoint3x4(center);

    // The radius takes the larger of the two scales across the axis, the height the scale along it.
    float WorldRadius
    {
        get
        {
            Vector3 scale = Pose.AbsoluteScale;
            return Mathf.Abs(radius) * Mathf.Max(scale[(direction + 1) % 3], scale[(direction + 2) % 3]);
        }
    }

    Vector3 HalfAxis
    {
        get
        {
            Vector3 axis = Vector3.zero;
            axis[direction] = Mathf.Max(0f, 0.5f * Mathf.Abs(height) * Pose.AbsoluteScale[direction] - WorldRadius);
            return Pose.Rotation * axis;
        }
    }

    PhysicsCapsule Shape => new(WorldCenter, HalfAxis, WorldRadius);

    internal override bool HasShape => true;
    internal override Bounds WorldBounds => Shape.Bounds;
    internal override bool OverlapsBox(in PhysicsBox box) => Shape.Overlaps(box);
    internal override bool OverlapsSphere(Vector3 center, float radius) => Shape.OverlapsSphere(center, radius);
    internal override void MeetRay(ref PhysicsRay ray) => ray.MeetCapsule(Shape);
    internal override Vector3 ClosestPointCore(Vector3 position) => Shape.ClosestPoint(position);

    internal override void FitToMesh()
    {
        if (ColliderFit.MeshBounds(this) is not { } bounds) return;
        center = bounds.center;
        radius = Mathf.Max(bounds.extents.x, bounds.extents.z);
        height = bounds.size.y;
    }
}
