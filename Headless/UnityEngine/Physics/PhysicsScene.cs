using System;
using Headless.Engine;

namespace UnityEngine;

public struct PhysicsScene : IEquatable<PhysicsScene>
{
    readonly int m_Handle;

    internal PhysicsScene(int handle) => m_Handle = handle;

    public bool IsValid() => m_Handle != 0;

    public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results) =>
        OverlapBox(center, halfExtents, results, Quaternion.identity);

    public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int layerMask = Physics.DefaultRaycastLayers,
        QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
    {
        RequireValid();
        return PhysicsWorld.Fill(PhysicsWorld.OverlapBox(center, halfExtents, orientation, layerMask, queryTriggerInteraction, m_Handle), results);
    }

    public int OverlapSphere(Vector3 position, float radius, Collider[] results, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
    {
        RequireValid();
        return PhysicsWorld.Fill(PhysicsWorld.OverlapSphere(position, radius, layerMask, queryTriggerInteraction, m_Handle), results);
    }

    public bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance = float.PositiveInfinity, int layerMask = Physics.DefaultRaycastLayers,
        QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
    {
        RequireValid();
        return PhysicsWorld.Raycast(origin, direction, maxDistance, layerMask, queryTriggerInteraction, out hitInfo, m_Handle);
    }

    public void Simulate(float step)
    {
        RequireValid();
        if (m_Handle != PhysicsWorld.DefaultScene) PhysicsWorld.Sync(); // no body of a preview scene moves
        else if (Physics.MayScriptsSimulate("PhysicsScene")) PhysicsWorld.Simulate(step);
    }

    void RequireValid()
    {
        if (m_Handle == 0) throw new InvalidOperationException("Cannot use the physics scene as it is invalid.");
    }

    public bool Equals(PhysicsScene other) => m_Handle == other.m_Handle;
    public override bool Equals(object? other) => other is PhysicsScene scene && Equals(scene);
    public override int GetHashCode() => m_Handle;
    public override string ToString() => $"({m_Handle})";
    public static bool operator ==(PhysicsScene lhs, PhysicsScene rhs) => lhs.Equals(rhs);
    public static bool operator !=(PhysicsScene lhs, PhysicsScene rhs) => !lhs.Equals(rhs);
}
