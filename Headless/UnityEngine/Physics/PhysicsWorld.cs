using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Enabled colliders and bodies of all scenes, the queries over them and the physics step.</summary>
static class PhysicsWorld
{
    static readonly List<Collider> s_Colliders = new();
    static readonly List<Rigidbody> s_Bodies = new();

    public static void Add(Collider collider) => s_Colliders.Add(collider);

    public static void Remove(Collider collider)
    {
        int index = s_Colliders.FindIndex(c => ReferenceEquals(c, collider));
        if (index >= 0) s_Colliders.RemoveAt(index);
    }

    public static void Add(Rigidbody body) => s_Bodies.Add(body);

    public static void Remove(Rigidbody body) => s_Bodies.Remove(body);

    public static void Clear()
    {
        s_Colliders.Clear();
        s_Bodies.Clear();
    }

    /// <summary>Moves the bodies, then takes over where all is.</summary>
    public static void Simulate(float step)
    {
        if (s_Bodies.Count > 0 && step > 0f)
        {
            Sync();
            List<Collider> solid = s_Colliders.FindAll(c => !c.isTrigger);
            foreach (Rigidbody body in s_Bodies)
                if (!body.isKinematic) RigidbodyMotion.Step(body, step, solid);
        }
        Sync();
    }

    public static void Sync()
    {
        foreach (Collider collider in s_Colliders) collider.SyncPose();
    }

    /// <summary>Physics scene of the loaded scenes; a preview scene's is its own handle.</summary>
    public const int DefaultScene = 1;

    public static List<Collider> OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask, QueryTriggerInteraction triggers, int scene = DefaultScene)
    {
        var size = new Vector3(MathF.Abs(halfExtents.x), MathF.Abs(halfExtents.y), MathF.Abs(halfExtents.z));
        PhysicsBox box = PhysicsBox.Oriented(center, size, Quaternion.Normalize(orientation));
        return Query(scene, layerMask, triggers, c => c.OverlapsBox(box));
    }

    public static List<Collider> OverlapSphere(Vector3 center, float radius, int layerMask, QueryTriggerInteraction triggers, int scene = DefaultScene) =>
        Query(scene, layerMask, triggers, c => c.OverlapsSphere(center, radius));

    public static int Fill(List<Collider> found, Collider[] results)
    {
        int count = Math.Min(found.Count, results.Length);
        found.CopyTo(0, results, 0, count);
        return count;
    }

    /// <summary>The first collider on a ray.</summary>
    public static bool Raycast(Vector3 origin, Vector3 direction, float reach, int layerMask, QueryTriggerInteraction triggers, out RaycastHit hit, int scene = DefaultScene)
    {
        hit = default;
        if (direction.sqrMagnitude == 0f) return false;
        var ray = new PhysicsRay(origin, direction.normalized, reach);
        Collider? first = null;
        foreach (Collider collider in Query(scene, layerMask, triggers, _ => true))
        {
            PhysicsRay tried = ray;
            collider.MeetRay(ref tried);
            if (!tried.IsHit || first is not null && tried.Distance >= ray.Distance) continue;
            (ray, first) = (tried, collider);
        }
        if (first is not null) hit = new RaycastHit(first, ray.Distance, ray.Point, ray.Normal);
        return first is not null;
    }

    static List<Collider> Query(int scene, int layerMask, QueryTriggerInteraction triggers, Predicate<Collider> overlaps)
    {
        if (Physics.autoSyncTransforms) Sync();
        bool hitTriggers = triggers == QueryTriggerInteraction.Collide || (triggers == QueryTriggerInteraction.UseGlobal && Physics.queriesHitTriggers);
        var found = new List<Collider>();
        foreach (Collider collider in s_Colliders)
        {
            if (SceneOf(collider) != scene) continue;
            if ((layerMask & (1 << collider.gameObject.layer)) == 0) continue;
            if (collider.isTrigger && !hitTriggers) continue;
            if (collider.HasShape && overlaps(collider)) found.Add(collider);
        }
        return found;
    }

    static int SceneOf(Collider collider) =>
        collider.OwnerOrNull?.SceneData is { IsPreview: true } preview ? preview.Handle : DefaultScene;
}
