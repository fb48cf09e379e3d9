using Headless.Engine;

namespace UnityEngine;

public partial class Rigidbody
{
    /// <summary>Given since the last physics step; the next one uses them up.</summary>
    internal Vector3 AddedVelocity { get; set; }
    internal Vector3 AddedAngularVelocity { get; set; }
    internal Vector3 AddedForce { get; set; }
    internal Vector3 AddedTorque { get; set; }

    public void AddForce(Vector3 force) => AddForce(force, ForceMode.Force);

    public void AddForce(Vector3 force, ForceMode mode)
    {
        if (RigidbodyInput.Refuses(this, "force", force) || isKinematic) return;
        WakeBy(force);
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
        if (RigidbodyInput.Refuses(this, "torque", torque) || isKinematic) return;
        WakeBy(torque);
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
        if (RigidbodyInput.Refuses(this, "force", force) || RigidbodyInput.Refuses(this, "position", position)) return;
        AddForce(force, mode);
        AddTorque(Vector3.Cross(position - worldCenterOfMass, force), mode);
    }

    public Vector3 GetAccumulatedForce() => GetAccumulatedForce(Time.fixedDeltaTime);

    /// <summary>What the next physics step will be given as a force, of all modes.</summary>
    public Vector3 GetAccumulatedForce(float step) => AddedForce + AddedVelocity * (mass / step);

    public Vector3 GetAccumulatedTorque() => GetAccumulatedTorque(Time.fixedDeltaTime);

    public Vector3 GetAccumulatedTorque(float step) => AddedTorque + RigidbodyMotion.TimesInertia(this, AddedAngularVelocity / step);
}
