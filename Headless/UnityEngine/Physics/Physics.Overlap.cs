using Headless.Engine;

namespace UnityEngine;

public partial class Physics
{
    public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents) => OverlapBox(center, halfExtents, Quaternion.identity);
    public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation) => OverlapBox(center, halfExtents, orientation, AllLayers);
    public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask) => OverlapBox(center, halfExtents, orientation, layerMask, QueryTriggerInteraction.UseGlobal);

    public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.OverlapBox(center, halfExtents, orientation, layerMask, queryTriggerInteraction).ToArray();

    public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results) => OverlapBoxNonAlloc(center, halfExtents, results, Quaternion.identity);
    public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation) => OverlapBoxNonAlloc(center, halfExtents, results, orientation, AllLayers);

    public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask) =>
        OverlapBoxNonAlloc(center, halfExtents, results, orientation, mask, QueryTriggerInteraction.UseGlobal);

    public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.Fill(PhysicsWorld.OverlapBox(center, halfExtents, orientation, mask, queryTriggerInteraction), results);

    public static bool CheckBox(Vector3 center, Vector3 halfExtents) => CheckBox(center, halfExtents, Quaternion.identity);
    public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation) => CheckBox(center, halfExtents, orientation, DefaultRaycastLayers);
    public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask) => CheckBox(center, halfExtents, orientation, layerMask, QueryTriggerInteraction.UseGlobal);

    public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layermask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.OverlapBox(center, halfExtents, orientation, layermask, queryTriggerInteraction).Count > 0;

    public static Collider[] OverlapSphere(Vector3 position, float radius) => OverlapSphere(position, radius, AllLayers);
    public static Collider[] OverlapSphere(Vector3 position, float radius, int layerMask) => OverlapSphere(position, radius, layerMask, QueryTriggerInteraction.UseGlobal);

    public static Collider[] OverlapSphere(Vector3 position, float radius, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.OverlapSphere(position, radius, layerMask, queryTriggerInteraction).ToArray();

    public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results) => OverlapSphereNonAlloc(position, radius, results, AllLayers);
    public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask) => OverlapSphereNonAlloc(position, radius, results, layerMask, QueryTriggerInteraction.UseGlobal);

    public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.Fill(PhysicsWorld.OverlapSphere(position, radius, layerMask, queryTriggerInteraction), results);

    public static bool CheckSphere(Vector3 position, float radius) => CheckSphere(position, radius, DefaultRaycastLayers);
    public static bool CheckSphere(Vector3 position, float radius, int layerMask) => CheckSphere(position, radius, layerMask, QueryTriggerInteraction.UseGlobal);

    public static bool CheckSphere(Vector3 position, float radius, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.OverlapSphere(position, radius, layerMask, queryTriggerInteraction).Count > 0;
}
