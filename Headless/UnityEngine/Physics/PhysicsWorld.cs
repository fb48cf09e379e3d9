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

    /// <summary>Empties it, with the settings that a script can leave behind.</summary>
    public static void Clear()
    {
        s_Colliders.Clear();
        s_Bodies.Clear();
        (Physics.simulationMode, Physics.autoSyncTransforms) = (SimulationMode.FixedUpdate, false);
    }

    /// <summary>Moves the bodies, then takes over where all is.</summary>
    public static void Simulate(float step)
    {
        if (s_Bodies.Count > 0 && step > 0f)
        {
            Sync();
            foreach (Rigidbody body in s_Bodies) body.Pose.Begin();
            List<Collider> solid = s_Colliders.FindAll(c => !c.isTrigger);
            foreach (Rigidbody body in s_Bodies)
                if (body.isKinematic && RigidbodyMotion.StepKinematic(body, step)) WakeTouching(body);
            RigidbodyMotion.Step(s_Bodies.FindAll(b => !b.isKinematic && !b.IsSleeping()), step, solid);
        }
        Sync();
    }

    /// <summary>Takes over Transforms that others than physics have moved, and puts colliders where their bodies are.</summary>
    public static void Sync()
    {
        foreach (Rigidbody body in s_Bodies) body.TakeTransform();
        foreach (Collider collider in s_Colliders) SyncPose(collider);
    }

    /// <summary>Puts the colliders of a body where it is.</summary>
    public static void SyncColliders(Rigidbody body)
    {
        foreach (Collider collider in s_Colliders)
            if (ReferenceEquals(collider.attachedRigidbody, body)) SyncPose(collider);
    }

    /// <summary>At the start of a frame: Transforms are where their bodies are.</summary>
    public static void ResetPoses()
    {
        foreach (Rigidbody body in s_Bodies) body.Pose.Reset();
    }

    /// <summary>After a frame's fixed steps: shows bodies where their interpolation has them at the frame's time.</summary>
    public static void Interpolate()
    {
        if (Physics.simulationMode != SimulationMode.FixedUpdate) return;
        float since = (float)(FrameClock.Time - FrameClock.FixedTime);
        foreach (Rigidbody body in s_Bodies)
            if (body.interpolation == RigidbodyInterpolation.Interpolate) body.Pose.ShowBetween(since / FrameClock.FixedDeltaTime);
            else if (body.interpolation == RigidbodyInterpolation.Extrapolate) body.Pose.ShowAhead(since * body.velocity, since * body.angularVelocity);
    }

    static void SyncPose(Collider collider)
    {
        if (collider.attachedRigidbody is { IsAdded: true } body) body.Pose.WhereItIs(collider.SyncPose);
        else collider.SyncPose();
    }

    // A sleeping body is not woken by what only rests at it.
    static void WakeTouching(Rigidbody moved)
    {
        foreach (Collider mover in s_Colliders)
        {
            if (mover.isTrigger || !ReferenceEquals(mover.attachedRigidbody, moved)) continue;
            Bounds reach = mover.WorldBounds;
            reach.Expand(2f * mover.contactOffset);
            foreach (Collider other in s_Colliders)
                if (!other.isTrigger && other.attachedRigidbody is { isKinematic: false } touched && reach.Intersects(other.WorldBounds)) touched.WakeUp();
        }
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
