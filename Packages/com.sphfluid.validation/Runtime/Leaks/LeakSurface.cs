using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The surface of a scene as a mesh collider of the engine, by the same steps to the solver as colliders of a simulation.</summary>
    sealed class LeakSurface : IDisposable
    {
        readonly FluidObstacles obstacles;
        readonly GameObject parent, holder;
        readonly Mesh mesh;

        public LeakSurface(LeakScene scene)
        {
            TriangleMesh triangles = scene.Mesh;
            mesh = new Mesh { name = scene.Name, hideFlags = HideFlags.HideAndDontSave, indexFormat = UnityEngine.Rendering.IndexFormat.UInt32 };
            mesh.vertices = triangles.Vertices;
            mesh.triangles = triangles.Indices;
            parent = new GameObject(scene.Name + " Parent") { hideFlags = HideFlags.HideAndDontSave };
            holder = new GameObject(scene.Name) { hideFlags = HideFlags.HideAndDontSave };
            holder.transform.SetParent(parent.transform, false);
            MeshCollider collider = holder.AddComponent<MeshCollider>();
            collider.sharedMesh = mesh;
            obstacles = new FluidObstacles(scene.Settings);
            obstacles.Add(collider);
        }

        /// <summary>Times the surface went too far in a frame to be followed, since the start.</summary>
        public int Jumps => obstacles.Jumps;

        public void GiveTo(FluidSolver solver) => solver.SetObstacles(obstacles);

        /// <summary>Moves the surface; the solver's next steps take it there.</summary>
        public void MoveTo(LeakPose pose)
        {
            parent.transform.localPosition = pose.Position;
            parent.transform.localScale = pose.ParentScale;
            holder.transform.localRotation = pose.Rotation;
            holder.transform.localScale = pose.Scale;
            obstacles.Update(Matrix4x4.identity);
        }

        public void Dispose()
        {
            obstacles.Dispose();
            UnityEngine.Object.DestroyImmediate(parent);
            UnityEngine.Object.DestroyImmediate(mesh);
        }
    }
}
