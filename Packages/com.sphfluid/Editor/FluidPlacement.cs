using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Editor
{
    /// <summary>Where the menu puts what it makes: where the user looks, standing on what lies below.</summary>
    internal static class FluidPlacement
    {
        private const int RaysASide = 3;
        private const int Attempts = 16, MostAtAPoint = 16;
        private const float PointRadius = 1e-4f; // m

        /// <summary>The point that the Scene view turns about; the origin where none is open.</summary>
        public static Vector3 Pivot => SceneView.lastActiveSceneView != null ? SceneView.lastActiveSceneView.pivot : Vector3.zero;

        /// <summary>Stands a box on the highest surface below it: on a collider, else on the plane y = 0.</summary>
        /// <param name="placed">The object at the box's centre; its rotation stays.</param>
        /// <param name="pivot">Where the box is to be [m]; of the height only as much counts as says which surfaces lie below.</param>
        /// <param name="size">Edge lengths of the box [m].</param>
        /// <param name="margin">Space under the box [m].</param>
        public static void Stand(Transform placed, Vector3 pivot, Vector3 size, float margin = 0f)
        {
            Vector3 half = HalfExtents(placed.rotation, size);
            float floor = Floor(placed.gameObject.scene, pivot, half) ?? 0f;
            placed.position = new Vector3(pivot.x, floor + margin + half.y, pivot.z);
        }

        /// <summary>
        /// Height of the highest surface of colliders in a box's outline, below its upper end where it stands at a pivot; null where there
        /// is none.
        /// </summary>
        public static float? Floor(Scene scene, Vector3 pivot, Vector3 half)
        {
            PhysicsScene physics = scene.GetPhysicsScene();
            Physics.SyncTransforms();
            float? floor = null;
            for (int i = 0; i < RaysASide; i++)
            {
                for (int k = 0; k < RaysASide; k++)
                {
                    var start = new Vector3(pivot.x + Part(i) * half.x, pivot.y + 2f * half.y, pivot.z + Part(k) * half.z);
                    if (TryFindSurface(physics, start, half.y, out float height)) floor = Mathf.Max(floor ?? height, height);
                }
            }
            return floor;
        }

        // A ray does not meet what it starts in, so it starts above that.
        private static bool TryFindSurface(PhysicsScene physics, Vector3 start, float step, out float height)
        {
            for (int i = 0; i < Attempts && TopOfSolid(physics, start) is float top; i++) start.y = Mathf.Max(top, start.y + step);
            bool hits = physics.Raycast(start, Vector3.down, out RaycastHit hit, float.PositiveInfinity, Physics.DefaultRaycastLayers,
                QueryTriggerInteraction.Ignore);
            height = hits ? hit.point.y : 0f;
            return hits;
        }

        private static float? TopOfSolid(PhysicsScene physics, Vector3 point)
        {
            var found = new Collider[MostAtAPoint];
            int count = physics.OverlapSphere(point, PointRadius, found, Physics.DefaultRaycastLayers, QueryTriggerInteraction.Ignore);
            for (int i = 0; i < count; i++)
                if (IsSolid(found[i])) return found[i].bounds.max.y + PointRadius;
            return null;
        }

        // Other meshes and terrains have a surface but no inside.
        private static bool IsSolid(Collider collider) => collider is BoxCollider || collider is SphereCollider ||
            collider is CapsuleCollider || collider is MeshCollider { convex: true };

        private static float Part(int ray) => 2f * ray / (RaysASide - 1) - 1f;

        private static Vector3 HalfExtents(Quaternion rotation, Vector3 size)
        {
            Vector3 x = rotation * new Vector3(size.x, 0f, 0f), y = rotation * new Vector3(0f, size.y, 0f),
                z = rotation * new Vector3(0f, 0f, size.z);
            return 0.5f * new Vector3(Mathf.Abs(x.x) + Mathf.Abs(y.x) + Mathf.Abs(z.x), Mathf.Abs(x.y) + Mathf.Abs(y.y) + Mathf.Abs(z.y),
                Mathf.Abs(x.z) + Mathf.Abs(y.z) + Mathf.Abs(z.z));
        }
    }
}
