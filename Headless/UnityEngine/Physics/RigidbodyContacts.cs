using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>
/// Contacts of a body's corners, or of its balls and capsules, with colliders that stand still: impulses one after the other, Coulomb's
/// friction of Unity's default material. Less than PhysX does: edges against edges and bodies among themselves pass each other.
/// </summary>
sealed class RigidbodyContacts
{
    const float Friction = 0.6f;
    const int Sweeps = 10;

    readonly Rigidbody m_Body;
    readonly float m_Step;
    readonly List<Contact> m_Contacts = new();

    struct Contact
    {
        public Vector3 Arm;
        public Vector3 Normal;
        public float Gap;
        public float Push;
        public Vector3 Held;
    }

    public RigidbodyContacts(Rigidbody body, List<Collider> obstacles, float step)
    {
        m_Body = body;
        m_Step = step;
        if (obstacles.Count == 0) return;
        float reach = step * (body.velocity.magnitude + 2f * body.angularVelocity.magnitude) + Physics.defaultContactOffset;
        foreach (Collider collider in body.gameObject.GetComponentsInChildren<Collider>())
        {
            if (!collider.enabled || collider.isTrigger || !ReferenceEquals(collider.attachedRigidbody, body)) continue;
            foreach ((Vector3 point, float radius) in ContactPoints.Of(collider))
                foreach (Collider obstacle in obstacles) Touch(obstacle, point, radius, reach);
        }
    }

    /// <summary>Changes the velocities.</summary>
    /// <returns>How the body is put out of what it is in.</returns>
    public Vector3 Resolve()
    {
        for (int sweep = 0; sweep < Sweeps; sweep++)
            for (int i = 0; i < m_Contacts.Count; i++) m_Contacts[i] = Solve(m_Contacts[i]);
        Vector3 deepest = Vector3.zero;
        foreach (Contact contact in m_Contacts)
            if (contact.Gap < 0f && -0.2f * contact.Gap > deepest.magnitude) deepest = -0.2f * contact.Gap * contact.Normal;
        return deepest;
    }

    void Touch(Collider obstacle, Vector3 point, float radius, float reach)
    {
        if (!obstacle.HasShape) return;
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
        if (gap < reach) m_Contacts.Add(new Contact { Arm = point - radius * normal - m_Body.worldCenterOfMass, Normal = normal, Gap = gap });
    }

    Contact Solve(Contact c)
    {
        Vector3 velocity = m_Body.velocity + Vector3.Cross(m_Body.angularVelocity, c.Arm);
        float before = c.Push;
        c.Push = MathF.Max(0f, before - (Vector3.Dot(velocity, c.Normal) + MathF.Max(0f, c.Gap) / m_Step) / Ease(c.Arm, c.Normal));
        Give((c.Push - before) * c.Normal, c.Arm);
        velocity = m_Body.velocity + Vector3.Cross(m_Body.angularVelocity, c.Arm);
        Vector3 along = velocity - Vector3.Dot(velocity, c.Normal) * c.Normal, was = c.Held;
        if (along.sqrMagnitude > 1e-12f) c.Held = Vector3.ClampMagnitude(was - along / Ease(c.Arm, along.normalized), Friction * c.Push);
        Give(c.Held - was, c.Arm);
        return c;
    }

    // What an impulse of 1 changes of the velocity there.
    float Ease(Vector3 arm, Vector3 direction) =>
        1f / m_Body.mass + Vector3.Dot(Vector3.Cross(RigidbodyMotion.PerInertia(m_Body, Vector3.Cross(arm, direction)), arm), direction);

    void Give(Vector3 impulse, Vector3 arm)
    {
        m_Body.velocity = RigidbodyMotion.FreeOf(m_Body.constraints, RigidbodyConstraints.FreezePositionX, m_Body.velocity + impulse / m_Body.mass);
        m_Body.angularVelocity = RigidbodyMotion.Turning(m_Body, m_Body.angularVelocity + RigidbodyMotion.PerInertia(m_Body, Vector3.Cross(arm, impulse)));
    }
}
