using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Names MeshColliders in the domain whose mesh cannot serve. Physics queries do not return a collider without a
    /// mesh, so these are looked for by themselves.
    /// </summary>
    internal static class MeshColliderChecks
    {
        public static void Check(in CollisionQuery query, List<FluidMessage> messages)
        {
            DomainPose worldToSimulation = query.WorldToSimulation;
            foreach (MeshCollider collider in SceneObjects.Find<MeshCollider>(query.Owner))
            {
                bool counts = collider.enabled && !collider.isTrigger && (query.Layers & (1 << collider.gameObject.layer)) != 0;
                if (!counts || !(ColliderTriangles.Problem(collider) is FluidMessage problem)) continue;
                if (messages.Exists(m => m.Context == collider)) continue;
                if (ColliderSettings.Find(collider) is IColliderSettings own && !own.AppliesTo(query.Owner)) continue;
                if (IntersectsDomain(collider, worldToSimulation, query.HalfExtents)) messages.Add(problem);
            }
        }

        // A mesh that cannot be read still has its bounds; one without vertices is where its transform is.
        private static bool IntersectsDomain(MeshCollider collider, in DomainPose worldToSimulation, Vector3 half)
        {
            Matrix4x4 toSimulation = worldToSimulation * collider.transform.localToWorldMatrix;
            Bounds bounds = collider.sharedMesh != null ? collider.sharedMesh.bounds : new Bounds();
            Vector3 center = toSimulation.MultiplyPoint3x4(bounds.center);
            Vector3 reach = AffineMath.Extents(toSimulation, bounds.extents);
            for (int axis = 0; axis < 3; axis++)
                if (Mathf.Abs(center[axis]) > half[axis] + reach[axis]) return false;
            return true;
        }
    }
}
