using UnityEngine;

namespace SphFluid
{
    /// <summary>What a liquid collides with: a collider of the scene, or a mesh that a script gave, as it was last seen.</summary>
    public sealed class FluidObstacle
    {
        internal FluidObstacle(in ColliderState state, float spacing, TriangleMesh mesh)
        {
            State = state;
            Spacing = spacing;
            Name = state.Key is Component component && component != null ? component.name : "mesh";
            Mesh = mesh;
        }

        /// <summary>The collider; null for the skin of a renderer, the pipe of an emitter and a mesh that a script gave.</summary>
        public Collider Collider => State.Collider;

        /// <summary>
        /// What it is of: a collider, the renderer of a skin, or the emitter whose pipe it is; null for a mesh that a script gave.
        /// </summary>
        public Component Source => State.Key as Component;

        /// <summary>All of its triangles in simulation space [m].</summary>
        public TriangleMesh Mesh { get; }

        /// <summary>State that the triangles were made for: as long as it lasts they are kept.</summary>
        internal ColliderState State { get; }

        /// <summary>Particle spacing that curved shapes were cut for [m].</summary>
        internal float Spacing { get; }

        internal string Name { get; }
    }
}
