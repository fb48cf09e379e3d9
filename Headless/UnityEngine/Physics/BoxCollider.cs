using Headless.Engine;

namespace UnityEngine;

public class BoxCollider : Collider
{
    public Vector3 center { get; set; }
    public Vector3 size { get; set; } = Vector3.one;

    internal PhysicsBox Shape => PhysicsBox.Oriented(
        Pose.LocalToWorld.MultiplyPoint3x4(center), Vector3.Scale(Pose.AbsoluteScale, new Vector3(Mathf.Abs(size.x), Mathf.Abs(size.y), Mathf.Abs(size.z)) * 0.5f), Pose.Rotation);

    internal override bool HasShape => true;
    internal override Bounds WorldBounds => Shape.Bounds;
    internal override bool OverlapsBox(in PhysicsBox box) => Shape.Intersects(box);
    internal override bool OverlapsSphere(Vector3 center, float radius) => (Shape.ClosestPoint(center) - center).sqrMagnitude <= radius * radius;
    internal override void MeetRay(ref PhysicsRay ray) => ray.MeetBox(Shape);
    internal override Vector3 ClosestPointCore(Vector3 position) => Shape.ClosestPoint(position);

    internal override void FitToMesh()
    {
        if (ColliderFit.MeshBounds(this) is not { } bounds) return;
        center = bounds.center;
        size = bounds.size;
    }
}
