using Headless.Engine;

namespace UnityEngine;

/// <summary>
/// A body that moves by forces, gravity and its own velocities in each physics step, and is stopped by colliders and other bodies where a corner of
/// one is in the other; there are no joints, and the Transform is not interpolated.
/// </summary>
public class Rigidbody : Component
{
    Vector3? m_CenterOfMass;
    Vector3? m_InertiaTensor;
    Quaternion m_InertiaTensorRotation = Quaternion.identity;

    public float mass { get; set; } = 1f;
    public bool isKinematic { get; set; }
    public bool useGravity { get; set; } = true;
    public bool detectCollisions { get; set; } = true;
    public RigidbodyConstraints constraints { get; set; }
    public RigidbodyInterpolation interpolation { get; set; }
    public float maxAngularVelocity { get; set; } = 7f;
    public Vector3 angularVelocity { get; set; }

    /// <summary>Of the centre of mass.</summary>
    public Vector3 velocity { get; set; }

    public float drag { get; set; }
    public float angularDrag { get; set; } = 0.05f;

    /// <summary>From the transform's origin along its axes, without its scale.</summary>
    public Vector3 centerOfMass { get => m_CenterOfMass ?? MassProperties.Of(this).Center; set => m_CenterOfMass = value; }

    public Vector3 inertiaTensor { get => m_InertiaTensor ?? MassProperties.Of(this).Moments; set => m_InertiaTensor = value; }

    public Quaternion inertiaTensorRotation
    {
        get => m_InertiaTensor is null ? MassProperties.Of(this).Axes : m_InertiaTensorRotation;
        set
        {
            m_InertiaTensor = inertiaTensor;
            m_InertiaTensorRotation = value;
        }
    }

    public Vector3 worldCenterOfMass => position + rotation * centerOfMass;
    public Vector3 position { get => transform.position; set => transform.position = value; }
    public Quaternion rotation { get => transform.rotation; set => transform.rotation = value; }

    public bool freezeRotation
    {
        get => (constraints & RigidbodyConstraints.FreezeRotation) == RigidbodyConstraints.FreezeRotation;
        set => constraints = value ? constraints | RigidbodyConstraints.FreezeRotation : constraints & ~RigidbodyConstraints.FreezeRotation;
    }

    /// <summary>Given since the last physics step; the next one uses them up.</summary>
    internal Vector3 AddedVelocity { get; set; }
    internal Vector3 AddedAngularVelocity { get; set; }
    internal Vector3 AddedForce { get; set; }
    internal Vector3 AddedTorque { get; set; }

    public void MovePosition(Vector3 position) => transform.position = position;
    public void MoveRotation(Quaternion rot) => transform.rotation = rot;
    public void Move(Vector3 position, Quaternion rotation) => transform.SetPositionAndRotation(position, rotation);
    public void ResetCenterOfMass() => m_CenterOfMass = null;
    public void ResetInertiaTensor() => m_InertiaTensor = null;
    public bool IsSleeping() => false;
    public void Sleep() => velocity = angularVelocity = Vector3.zero;
    public void WakeUp() { }

    public Vector3 GetPointVelocity(Vector3 worldPoint) => velocity + Vector3.Cross(angularVelocity, worldPoint - worldCenterOfMass);

    public void AddForce(Vector3 force) => AddForce(force, ForceMode.Force);

    public void AddForce(Vector3 force, ForceMode mode)
    {
        switch (mode)
        {
            case ForceMode.Impulse: AddedVelocity += force / mass; break;
            case ForceMode.VelocityChange: AddedVelocity += force; break;
            case ForceMode.Acceleration: AddedForce += force * mass; break;
            default: AddedForce += force; break;
        }
    }

    public void AddTorque(Vector3 torque) => AddTorque(torque, ForceMode.Force);

    public void AddTorque(Vector3 torque, ForceMode mode)
    {
        switch (mode)
        {
            case ForceMode.Impulse: AddedAngularVelocity += RigidbodyMotion.PerInertia(this, torque); break;
            case ForceMode.VelocityChange: AddedAngularVelocity += torque; break;
            case ForceMode.Acceleration: AddedTorque += RigidbodyMotion.TimesInertia(this, torque); break;
            default: AddedTorque += torque; break;
        }
    }

    public void AddForceAtPosition(Vector3 force, Vector3 position) => AddForceAtPosition(force, position, ForceMode.Force);

    public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode)
    {
        AddForce(force, mode);
        AddTorque(Vector3.Cross(position - worldCenterOfMass, force), mode);
    }

    internal override void OnAdded() => PhysicsWorld.Add(this);
    internal override void OnRemoved() => PhysicsWorld.Remove(this);
}
