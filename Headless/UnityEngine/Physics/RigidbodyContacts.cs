using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>
/// Contacts of all bodies in a step, of their corners, balls and capsules with colliders and other bodies: impulses one after the other, swept
/// over all, as PhysX solves them; Coulomb's friction of Unity's default material. Less than PhysX does: edges pass edges.
/// </summary>
sealed class RigidbodyContacts(List<Collider> obstacles, float step)
{
    const float Friction = 0.6f;
    const int Sweeps = 20;

    readonly List<Contact> m_Contacts = new();

    struct Contact
    {
        public Rigidbody Body;
        public Vector3 Arm;
        public Rigidbody? Other;
        public Vector3 OtherArm;
        public Vector3 Normal;
        public float Gap;
        public float Push;
        public Vector3 Held;
    }

    /// <summary>Finds what the body touches, or will within the step.</summary>
    public void Find(Rigidbody body)
    {
        if (obstacles.Count == 0) return;
        float reach = step * (body.velocity.magnitude + 2f * body.angularVelocity.magnitude) + Physics.defaultContactOffset;
        foreach (Collider collider in body.gameObject.GetComponentsInChildren<Collider>())
        {
            if (!collider.enabled || collider.isTrigger || !ReferenceEquals(collider.attachedRigidbody, body)) continue;
            foreach ((Vector3 point, float radius) in ContactPoints.Of(collider))
                foreach (Collider obstacle in obstacles) Touch(body, obstacle, point, radius, reach);
        }
    }

    /// <summary>Changes the velocities.</summary>
    public void Resolve()
    {
        for (int sweep = 0; sweep < Sweeps; sweep++)
            for (int i = 0; i < m_Contacts.Count; i++) m_Contacts[i] = Solve(m_Contacts[i]);
    }

    /// <summary>How a body is put out of what it is in.</summary>
    public Vector3 WayOut(Rigidbody body)
    {
        Vector3 deepest = Vector3.zero;
        foreach (Contact contact in m_Contacts)
            if (ReferenceEquals(contact.Body, body) && contact.Gap < 0f && -0.2f * contact.Gap > deepest.magnitude) deepest = -0.2f * contact.Gap * contact.Normal;
        return deepest;
    }

    void Touch(Rigidbody body, Collider obstacle, Vector3 point, float radius, float reach)
    {
        if (!obstacle.HasShape) return;
        Rigidbody? other = obstacle.attachedRigidbody;
        if (ReferenceEquals(other, body)) return;
        if (other is { isKinematic: true }) other = null;
        Vector3 offset = point - obstacle.ClosestPointCore(point);
        float distance = offset.magnitude;
        Vector3 normal = distance > 1e-6f ? offset / distance : Vector3.zero;
        if (distance <= 1e-6f)
        {
            if (obstacle is not BoxCollider box) return;
            (normal, distance) = box.Shape.WayOut(point);
            distance = -distance;
        }
        float gap = distance - radius;
        if (gap >= reach) return;
        if (other is not null && other.IsSleeping())
        {
            if (body.Rest.IsMoving) other.WakeUp();
            else other = null; // what is at rest on it leaves it asleep
        }
        Vector3 place = point - radius * normal;
        m_Contacts.Add(new Contact
        {
            Body = body, Arm = place - body.worldCenterOfMass, Normal = normal, Gap = gap, Other = other,
            OtherArm = other is null ? Vector3.zero : place - other.worldCenterOfMass,
        });
    }

    Contact Solve(Contact c)
    {
        float before = c.Push;
        c.Push = MathF.Max(0f, before - (Vector3.Dot(Approach(c), c.Normal) + MathF.Max(0f, c.Gap) / step) / Ease(c, c.Normal));
        Give(c, (c.Push - before) * c.Normal);
        Vector3 velocity = Approach(c), along = velocity - Vector3.Dot(velocity, c.Normal) * c.Normal, was = c.Held;
        if (along.sqrMagnitude > 1e-12f) c.Held = Vector3.ClampMagnitude(was - along / Ease(c, along.normalized), Friction * c.Push);
        Give(c, c.Held - was);
        return c;
    }

    Vector3 Approach(in Contact c) => VelocityAt(c.Body, c.Arm) - (c.Other is null ? Vector3.zero : VelocityAt(c.Other, c.OtherArm));

    // What an impulse of 1 changes of the velocity there.
    float Ease(in Contact c, Vector3 direction) => Ease(c.Body, c.Arm, direction) + (c.Other is null ? 0f : Ease(c.Other, c.OtherArm, direction));

    void Give(in Contact c, Vector3 impulse)
    {
        Give(c.Body, impulse, c.Arm);
        if (c.Other is not null) Give(c.Other, -impulse, c.OtherArm);
    }

    static Vector3 VelocityAt(Rigidbody body, Vector3 arm) => body.velocity + Vector3.Cross(body.angularVelocity, arm);

    static float Ease(Rigidbody body, Vector3 arm, Vector3 direction) =>
        1f / body.mass + Vector3.Dot(Vector3.Cross(RigidbodyMotion.PerInertia(body, Vector3.Cross(arm, direction)), arm), direction);

    static void Give(Rigidbody body, Vector3 impulse, Vector3 arm) => body.SetVelocities(
        RigidbodyMotion.FreeOf(body.constraints, RigidbodyConstraints.FreezePositionX, body.velocity + impulse / body.mass),
        RigidbodyMotion.Turning(body, body.angularVelocity + RigidbodyMotion.PerInertia(body, Vector3.Cross(arm, impulse))));
}
