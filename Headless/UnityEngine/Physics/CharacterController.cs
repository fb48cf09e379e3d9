using Headless.Engine;

namespace UnityEngine;

/// <summary>
/// The capsule only, which stays upright however the object is turned. There is no dynamics: scripts move the transform.
/// </summary>
public class CharacterController : Collider
{
    public Vector3 center { get; set; }
    public float radius { get; set; } = 0.5f;
    public float height { get; set; } = 2f;
    public float skinWidth { get; set; } = 0.08f;

    PhysicsCapsule Shape
    {
        get
        {
            Vector3 scale = Pose.AbsoluteScale;
            float worldRadius = Mathf.Abs(radius) * Mathf.Max(scale.x, scale.z);
            float half = Mathf.Max(0f, 0.5f * Mathf.Abs(height) * scale.y - worldRadius);
            return new PhysicsCapsule(Pose.LocalToWorld.MultiplyPoint3x4(center), half * Vector3.up, worldRadius);
        }
    }

    internal override bool HasShape => true;
    internal override Bounds WorldBounds => Shape.Bounds;
    internal override bool OverlapsBox(in PhysicsBox box) => Shape.Overlaps(box);
    internal override bool OverlapsSphere(Vector3 center, float radius) => Shape.OverlapsSphere(center, radius);
    internal override void MeetRay(ref PhysicsRay ray) => ray.MeetCapsule(Shape);
    internal override Vector3 ClosestPointCore(Vector3 position) => Shape.ClosestPoint(position);
}
