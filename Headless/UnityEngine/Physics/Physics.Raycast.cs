using Headless.Engine;

namespace UnityEngine;

public partial class Physics
{
    public static bool Raycast(Vector3 origin, Vector3 direction) => Raycast(origin, direction, out _);
    public static bool Raycast(Vector3 origin, Vector3 direction, float maxDistance) => Raycast(origin, direction, out _, maxDistance);
    public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo) => Raycast(origin, direction, out hitInfo, float.PositiveInfinity);
    public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance) => Raycast(origin, direction, out hitInfo, maxDistance, DefaultRaycastLayers);

    public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask) =>
        Raycast(origin, direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);

    public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
        PhysicsWorld.Raycast(origin, direction, maxDistance, layerMask, queryTriggerInteraction, out hitInfo);
}
