using UnityEngine;

namespace Headless.Engine;

/// <summary>Where a collider stood when transforms were last synchronised.</summary>
readonly struct ColliderPose
{
    public readonly Matrix4x4 LocalToWorld;
    public readonly Quaternion Rotation;
    public readonly Vector3 Scale;

    public ColliderPose(Transform transform)
    {
        LocalToWorld = transform.localToWorldMatrix;
        Rotation = transform.rotation;
        Scale = transform.lossyScale;
    }

    public ColliderPose(Vector3 position, Quaternion rotation, Vector3 scale)
    {
        LocalToWorld = Matrix4x4.TRS(position, rotation, scale);
        Rotation = rotation;
        Scale = scale;
    }

    public Vector3 AbsoluteScale => new(Mathf.Abs(Scale.x), Mathf.Abs(Scale.y), Mathf.Abs(Scale.z));
}
