using Headless.Engine;

namespace UnityEngine;

/// <summary>Shapes for queries and for bodies' contacts. No collision or trigger messages are sent.</summary>
public class Collider : Component
{
    bool m_Enabled = true;
    ColliderPose m_Pose;

    public bool enabled
    {
        get { CheckAlive(); return m_Enabled; }
        set
        {
            CheckAlive();
            if (m_Enabled == value) return;
            m_Enabled = value;
            RefreshActivation();
        }
    }

    public bool isTrigger { get; set; }
    public float contactOffset { get; set; } = 0.01f;
    public LayerMask includeLayers { get; set; }
    public LayerMask excludeLayers { get; set; }
    public Rigidbody attachedRigidbody => gameObject.GetComponentInParent<Rigidbody>(true);

    /// <summary>World box at the last sync; empty at the origin when the collider is disabled or inactive, as documented.</summary>
    public Bounds bounds => IsAdded ? WorldBounds : default;

    public Vector3 ClosestPoint(Vector3 position) => IsAdded ? ClosestPointCore(position) : position;
    public Vector3 ClosestPointOnBounds(Vector3 position) => bounds.ClosestPoint(position);

    internal ColliderPose Pose => m_Pose;
    internal virtual bool HasShape => false;
    internal virtual Bounds WorldBounds => default;
    internal virtual bool OverlapsBox(in PhysicsBox box) => false;
    internal virtual bool OverlapsSphere(Vector3 center, float radius) => false;
    internal virtual void MeetRay(ref PhysicsRay ray) { }
    internal virtual Vector3 ClosestPointCore(Vector3 position) => position;

    /// <summary>Takes over the transform's place: on enabling, at each physics step and in Physics.SyncTransforms.</summary>
    internal void SyncPose() => m_Pose = new ColliderPose(OwnerOrNull!.TransformCore);

    internal Vector3 ClosestPointAt(Vector3 point, Vector3 position, Quaternion rotation)
    {
        ColliderPose kept = m_Pose;
        m_Pose = new ColliderPose(position, rotation, transform.lossyScale);
        try
        {
            return ClosestPointCore(point);
        }
        finally
        {
            m_Pose = kept;
        }
    }

    internal override bool EnabledSelf => m_Enabled;

    internal override void OnAdded()
    {
        SyncPose();
        PhysicsWorld.Add(this);
    }

    internal override void OnRemoved() => PhysicsWorld.Remove(this);
}
