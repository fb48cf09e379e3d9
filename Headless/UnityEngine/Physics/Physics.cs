using Headless.Engine;

namespace UnityEngine;

/// <summary>Overlap queries and rays. Colliders are where they were at the last physics step or SyncTransforms, as with Unity's default settings.</summary>
public partial class Physics
{
    public const int IgnoreRaycastLayer = 1 << 2;
    public const int DefaultRaycastLayers = ~IgnoreRaycastLayer;
    public const int AllLayers = ~0;

    public static Vector3 gravity { get; set; } = new(0f, -9.81f, 0f);
    public static bool queriesHitTriggers { get; set; } = true;
    public static bool queriesHitBackfaces { get; set; }
    public static bool autoSyncTransforms { get; set; }
    public static SimulationMode simulationMode { get; set; } = SimulationMode.FixedUpdate;
    public static float sleepThreshold { get; set; } = 0.005f;
    public static float defaultContactOffset { get; set; } = 0.01f;
    public static PhysicsScene defaultPhysicsScene => new(PhysicsWorld.DefaultScene);

    public static void SyncTransforms() => PhysicsWorld.Sync();

    public static void Simulate(float step)
    {
        if (MayScriptsSimulate("Physics")) PhysicsWorld.Simulate(step);
    }

    internal static bool MayScriptsSimulate(string type)
    {
        if (simulationMode == SimulationMode.Script) return true;
        Debug.LogWarning($"{type}.Simulate(...) was called but simulation mode is not set to Script. You should set simulation mode to Script first before calling this function therefore the simulation was not run.");
        return false;
    }

    public static Vector3 ClosestPoint(Vector3 point, Collider collider, Vector3 position, Quaternion rotation) => collider.ClosestPointAt(point, position, rotation);
}
