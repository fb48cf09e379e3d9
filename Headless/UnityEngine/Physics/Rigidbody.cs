namespace UnityEngine;

/// <summary>Mass, flags and pose only: there is no dynamics, so a body stays where scripts put it.</summary>
public class Rigidbody : Component
{
    public float mass { get; set; } = 1f;
    public bool isKinematic { get; set; }
    public bool useGravity { get; set; } = true;
    public bool detectCollisions { get; set; } = true;
    public Vector3 angularVelocity { get; set; }
    public Vector3 centerOfMass { get; set; }
    public Vector3 worldCenterOfMass => transform.TransformPoint(centerOfMass);
    public Vector3 position { get => transform.position; set => transform.position = value; }
    public Quaternion rotation { get => transform.rotation; set => transform.rotation = value; }

    public void MovePosition(Vector3 position) => transform.position = position;
    public void MoveRotation(Quaternion rot) => transform.rotation = rot;
    public void Move(Vector3 position, Quaternion rotation) => transform.SetPositionAndRotation(position, rotation);
}
