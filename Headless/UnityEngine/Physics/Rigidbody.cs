using Headless.Engine;

namespace UnityEngine;

/// <summary>
/// A body that moves by forces, gravity and its own velocities in each physics step, and is stopped by colliders and other bodies where a corner of
/// one is in the other; there are no joints. Physics has a pose of its own, which the Transform shows.
/// </summary>
public partial class Rigidbody : Component
{
    Vector3? m_CenterOfMass;
    Vector3? m_InertiaTensor;
    Quaternion m_InertiaTensorRotation = Quaternion.identity;
    RigidbodyPose? m_Pose;
    Vector3 m_Velocity, m_AngularVelocity;
    float m_Mass = 1f;
    bool m_IsKinematic;

    public bool useGravity { get; set; } = true;
    public bool detectCollisions { get; set; } = true;
    public RigidbodyConstraints constraints { get; set; }
    public RigidbodyInterpolation interpolation { get; set; }
    public float maxAngularVelocity { get; set; } = 7f;
    public float drag { get; set; }
    public float angularDrag { get; set; } = 0.05f;
    public float sleepThreshold { get => Rest.Threshold; set => Rest.Threshold = Mathf.Max(0f, value); }

    public float mass
    {
        get => m_Mass;
        set
        {
            if (!RigidbodyInput.Refuses(this, "mass", value)) m_Mass = Mathf.Clamp(value, 1e-7f, 1e9f);
        }
    }

    public bool isKinematic
    {
        get => m_IsKinematic;
        set
        {
            m_IsKinematic = value;
            Rest.Wake();
        }
    }

    /// <summary>Of the centre of mass.</summary>
    public Vector3 velocity
    {
        get => m_Velocity;
        set
        {
            if (RigidbodyInput.Refuses(this, "velocity", value)) return;
            m_Velocity = value;
            WakeBy(value);
        }
    }

    public Vector3 angularVelocity
    {
        get => m_AngularVelocity;
        set
        {
            if (RigidbodyInput.Refuses(this, "angularVelocity", value)) return;
            m_AngularVelocity = value;
            WakeBy(value);
        }
    }

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

    /// <summary>As physics has it. Setting it takes the body there at once; the Transform follows with the next step.</summary>
    public Vector3 position
    {
        get => Pose.Position;
        set
        {
            if (!RigidbodyInput.Refuses(this, "position", value)) Put(value, Pose.Rotation);
        }
    }

    public Quaternion rotation
    {
        get => Pose.Rotation;
        set
        {
            if (!RigidbodyInput.Refuses(this, "rotation", value)) Put(Pose.Position, Quaternion.Normalize(value));
        }
    }

    public bool freezeRotation
    {
        get => (constraints & RigidbodyConstraints.FreezeRotation) == RigidbodyConstraints.FreezeRotation;
        set => constraints = value ? constraints | RigidbodyConstraints.FreezeRotation : constraints & ~RigidbodyConstraints.FreezeRotation;
    }

    internal RigidbodySleep Rest { get; } = new();

    internal RigidbodyPose Pose
    {
        get
        {
            m_Pose ??= new RigidbodyPose(transform);
            if (!IsAdded || Physics.autoSyncTransforms) TakeTransform();
            return m_Pose;
        }
    }

    /// <summary>Where a kinematic body goes in the next step.</summary>
    internal (Vector3 Position, Quaternion Rotation)? Target { get; set; }

    public void ResetCenterOfMass() => m_CenterOfMass = null;
    public void ResetInertiaTensor() => m_InertiaTensor = null;
    public bool IsSleeping() => Rest.IsAsleep;
    public void WakeUp() => Rest.Wake();

    public void Sleep()
    {
        m_Velocity = m_AngularVelocity = Vector3.zero;
        AddedVelocity = AddedAngularVelocity = AddedForce = AddedTorque = Vector3.zero;
        Rest.Sleep();
    }

    public Vector3 GetPointVelocity(Vector3 worldPoint) => velocity + Vector3.Cross(angularVelocity, worldPoint - worldCenterOfMass);

    public void MovePosition(Vector3 position)
    {
        if (!RigidbodyInput.Refuses(this, "position", position)) MoveTo(position, Target?.Rotation ?? rotation);
    }

    public void MoveRotation(Quaternion rot)
    {
        if (!RigidbodyInput.Refuses(this, "rotation", rot)) MoveTo(Target?.Position ?? position, rot);
    }

    public void Move(Vector3 position, Quaternion rotation)
    {
        if (!RigidbodyInput.Refuses(this, "position", position) && !RigidbodyInput.Refuses(this, "rotation", rotation)) MoveTo(position, rotation);
    }

    /// <summary>Velocities that a step leaves; they wake nothing.</summary>
    internal void SetVelocities(Vector3 linear, Vector3 angular) => (m_Velocity, m_AngularVelocity) = (linear, angular);

    /// <summary>Where others than physics have moved the Transform, the body is there.</summary>
    internal void TakeTransform()
    {
        if (m_Pose is not null && m_Pose.TakeChange()) Rest.Wake();
    }

    internal override void OnAdded()
    {
        m_Pose ??= new RigidbodyPose(transform);
        TakeTransform();
        PhysicsWorld.Add(this);
    }

    internal override void OnRemoved() => PhysicsWorld.Remove(this);

    void WakeBy(Vector3 given)
    {
        if (!given.Equals(Vector3.zero)) Rest.Wake();
    }

    // A body that is not kinematic is put there, as by its position.
    void MoveTo(Vector3 position, Quaternion rotation)
    {
        if (isKinematic) Target = (position, Quaternion.Normalize(rotation));
        else Put(position, Quaternion.Normalize(rotation));
    }

    void Put(Vector3 position, Quaternion rotation)
    {
        Pose.Put(position, rotation);
        Rest.Wake();
        if (IsAdded) PhysicsWorld.SyncColliders(this);
        else Pose.Show();
    }
}
