using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A surface of a scene as a mesh collider of the engine or, where the liquid moves it, as a rigid body.</summary>
    internal sealed class LeakSurface : IDisposable
    {
        private readonly LeakBody body;
        private readonly FluidObstacles obstacles;
        private readonly int[] cornerOf; // of each vertex of the mesh
        private readonly int floating; // its number
        private readonly GameObject parent, holder;
        private readonly Mesh mesh;

        /// <param name="body">The surface.</param>
        /// <param name="obstacles">Gets it.</param>
        public LeakSurface(LeakBody body, FluidObstacles obstacles)
        {
            this.body = body;
            this.obstacles = obstacles;
            TriangleMesh triangles = body.Mesh;
            cornerOf = new int[triangles.Vertices.Length];
            for (int k = triangles.Indices.Length - 1; k >= 0; k--) cornerOf[triangles.Indices[k]] = k;
            LeakPose start = body.PoseAt(0);
            if (body.Floats)
            {
                floating = obstacles.AddFloating(triangles, start.Position, start.Rotation, body.Mass, body.Inertia);
                return;
            }
            mesh = new Mesh
            {
                name = "Leak Surface", hideFlags = HideFlags.HideAndDontSave,
                indexFormat = UnityEngine.Rendering.IndexFormat.UInt32
            };
            mesh.vertices = triangles.Vertices;
            mesh.triangles = triangles.Indices;
            parent = new GameObject("Leak Surface Parent") { hideFlags = HideFlags.HideAndDontSave };
            holder = new GameObject("Leak Surface") { hideFlags = HideFlags.HideAndDontSave };
            holder.transform.SetParent(parent.transform, false);
            MeshCollider collider = holder.AddComponent<MeshCollider>();
            collider.sharedMesh = mesh;
            obstacles.Add(collider);
        }

        /// <summary>Puts the surface where the next steps are to take it.</summary>
        /// <param name="pose">Where it is then; of no effect on what floats.</param>
        /// <param name="corners">Its corners then, three a triangle, in its own space [m]; null: as they are.</param>
        public void MoveTo(LeakPose pose, Vector3[] corners)
        {
            if (body.Floats) return;
            parent.transform.localPosition = pose.Position;
            parent.transform.localScale = pose.ParentScale;
            holder.transform.localRotation = pose.Rotation;
            holder.transform.localScale = pose.Scale;
            if (corners == null) return;
            mesh.vertices = Array.ConvertAll(cornerOf, k => corners[k]);
            mesh.RecalculateBounds();
        }

        /// <summary>Pushes what floats, before the steps of a frame.</summary>
        public void Push(int frame)
        {
            if (body.Push == null) return;
            (Vector3 velocity, Vector3 spin) = body.Push(frame);
            obstacles.Push(floating, velocity, spin);
        }

        /// <summary>Where the steps left the surface.</summary>
        /// <param name="put">Where it was put.</param>
        public LeakPose Where(LeakPose put)
        {
            if (!body.Floats) return put;
            Vector3 centre = obstacles.ReadPoseNow(floating, out Quaternion rotation);
            return new LeakPose(centre, rotation);
        }

        public void Dispose()
        {
            if (parent == null) return;
            UnityEngine.Object.DestroyImmediate(parent);
            UnityEngine.Object.DestroyImmediate(mesh);
        }
    }
}
