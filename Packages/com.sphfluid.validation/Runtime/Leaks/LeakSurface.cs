using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The surface of a scene as a mesh collider of the engine, by the same steps to the solver as colliders of a simulation.</summary>
    sealed class LeakSurface : IDisposable
    {
        // The last of Unity's layers, so that nothing else is found there.
        const int Layer = 31;

        readonly CollisionScene colliders = new CollisionScene();
        readonly CollisionBodies bodies;
        readonly FluidSolverSettings settings;
        readonly GameObject parent, holder;
        readonly Mesh mesh;

        public LeakSurface(LeakScene scene)
        {
            settings = scene.Settings;
            bodies = new CollisionBodies(settings);
            TriangleMesh triangles = scene.Mesh;
            mesh = new Mesh { name = scene.Name, hideFlags = HideFlags.HideAndDontSave, indexFormat = UnityEngine.Rendering.IndexFormat.UInt32 };
            mesh.vertices = triangles.Vertices;
            mesh.triangles = triangles.Indices;
            parent = new GameObject(scene.Name + " Parent") { hideFlags = HideFlags.HideAndDontSave };
            holder = new GameObject(scene.Name) { layer = Layer, hideFlags = HideFlags.HideAndDontSave };
            holder.transform.SetParent(parent.transform, false);
            holder.AddComponent<MeshCollider>().sharedMesh = mesh;
        }

        /// <summary>Times the surface went too far in a frame to be followed, since the start.</summary>
        public int Jumps => bodies.Jumps;

        public void GiveTo(FluidSolver solver) => solver.SetBodies(bodies);

        /// <summary>Moves the surface; the solver's next steps take it there.</summary>
        /// <exception cref="FluidDeviceException">Other colliders are there too.</exception>
        public void MoveTo(LeakPose pose)
        {
            parent.transform.localPosition = pose.Position;
            parent.transform.localScale = pose.ParentScale;
            holder.transform.localRotation = pose.Rotation;
            holder.transform.localScale = pose.Scale;
            colliders.Gather(new CollisionQuery
            {
                Scene = Physics.defaultPhysicsScene,
                Rotation = Quaternion.identity,
                DomainSize = settings.DomainSize,
                Layers = 1 << Layer,
                Spacing = settings.Spacing,
            });
            if (colliders.Solids.Count != 1)
            {
                throw new FluidDeviceException($"{colliders.Solids.Count} colliders were found for '{holder.name}' instead of one. " +
                    $"Run it in an empty scene, without colliders on layer {Layer}.");
            }
            bodies.Update(colliders.Solids);
        }

        public void Dispose()
        {
            bodies.Dispose();
            colliders.Dispose();
            UnityEngine.Object.DestroyImmediate(parent);
            UnityEngine.Object.DestroyImmediate(mesh);
        }
    }
}
