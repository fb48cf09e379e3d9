namespace UnityEngine;

/// <summary>Where a ray met a collider.</summary>
public struct RaycastHit
{
    internal RaycastHit(Collider collider, float distance, Vector3 point, Vector3 normal)
    {
        this.collider = collider;
        this.distance = distance;
        this.point = point;
        this.normal = normal;
    }

    public Collider collider { get; }
    public float distance { get; set; }
    public Vector3 point { get; set; }
    public Vector3 normal { get; set; }
    public Rigidbody rigidbody => collider ? collider.attachedRigidbody : null!;
    public Transform transform => collider ? collider.transform : null!;
}
