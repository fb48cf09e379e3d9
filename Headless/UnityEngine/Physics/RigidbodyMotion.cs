using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A physics step of bodies as PhysX takes it: forces, gravity, damping, contacts, then the pose. No gyroscopic torque.</summary>
static class RigidbodyMotion
{
    public static void Step(List<Rigidbody> bodies, float dt, List<Collider> obstacles)
    {
        foreach (Rigidbody body in bodies) Hasten(body, dt);
        var contacts = new RigidbodyContacts(obstacles, dt);
        foreach (Rigidbody body in bodies)
            if (body.detectCollisions) contacts.Find(body);
        contacts.Resolve();
        foreach (Rigidbody body in bodies) Move(body, dt, contacts.WayOut(body));
    }

    static void Hasten(Rigidbody body, float dt)
    {
        Vector3 velocity = body.velocity + body.AddedVelocity + dt / body.mass * body.AddedForce + (body.useGravity ? dt * Physics.gravity : Vector3.zero);
        Vector3 angular = body.angularVelocity + body.AddedAngularVelocity + PerInertia(body, dt * body.AddedTorque);
        body.AddedVelocity = body.AddedAngularVelocity = body.AddedForce = body.AddedTorque = Vector3.zero;
        velocity *= Mathf.Max(0f, 1f - dt * body.drag);
        angular *= Mathf.Max(0f, 1f - dt * body.angularDrag);
        body.SetVelocities(FreeOf(body.constraints, RigidbodyConstraints.FreezePositionX, velocity), Vector3.ClampMagnitude(Turning(body, angular), body.maxAngularVelocity));
    }

    static void Move(Rigidbody body, float dt, Vector3 depth)
    {
        Vector3 center = body.worldCenterOfMass + dt * body.velocity + depth;
        float angle = body.angularVelocity.magnitude * dt;
        Quaternion turn = angle > 0f ? Quaternion.AngleAxis(angle * Mathf.Rad2Deg, body.angularVelocity.normalized) : Quaternion.identity;
        Quaternion rotation = Quaternion.Normalize(turn * body.rotation);
        body.Pose.MoveTo(center - rotation * body.centerOfMass, rotation);
        if (body.Rest.Pass(body, dt)) body.Sleep();
    }

    /// <summary>Takes a kinematic body to where it was told to go; its velocities are those of the way there.</summary>
    /// <returns>Whether it moves.</returns>
    public static bool StepKinematic(Rigidbody body, float dt)
    {
        (Vector3 position, Quaternion rotation) = body.Target ?? (body.position, body.rotation);
        (rotation * Quaternion.Inverse(body.rotation)).ToAngleAxis(out float angle, out Vector3 axis);
        if (angle > 180f) angle -= 360f;
        Vector3 turn = body.Target is null ? Vector3.zero : angle * Mathf.Deg2Rad / dt * axis;
        body.SetVelocities((position - body.position) / dt, turn);
        if (body.Target is null) return false;
        body.Pose.MoveTo(position, rotation);
        body.Target = null;
        return !body.velocity.Equals(Vector3.zero) || !turn.Equals(Vector3.zero);
    }

    /// <summary>An angular impulse over the inertia.</summary>
    public static Vector3 PerInertia(Rigidbody body, Vector3 impulse) => InAxes(body, impulse, (moment, part) => moment > 0f ? part / moment : 0f);

    /// <summary>An angular acceleration times the inertia.</summary>
    public static Vector3 TimesInertia(Rigidbody body, Vector3 acceleration) => InAxes(body, acceleration, (moment, part) => moment * part);

    // Positions freeze along the world's axes, rotations about the body's own.
    public static Vector3 Turning(Rigidbody body, Vector3 angular) =>
        body.rotation * FreeOf(body.constraints, RigidbodyConstraints.FreezeRotationX, Quaternion.Inverse(body.rotation) * angular);

    public static Vector3 FreeOf(RigidbodyConstraints constraints, RigidbodyConstraints first, Vector3 v)
    {
        for (int axis = 0; axis < 3; axis++)
            if (((int)constraints & ((int)first << axis)) != 0) v[axis] = 0f;
        return v;
    }

    static Vector3 InAxes(Rigidbody body, Vector3 v, Func<float, float, float> change)
    {
        Quaternion axes = body.rotation * body.inertiaTensorRotation;
        Vector3 parts = Quaternion.Inverse(axes) * v, moments = body.inertiaTensor;
        return axes * new Vector3(change(moments.x, parts.x), change(moments.y, parts.y), change(moments.z, parts.z));
    }
}
