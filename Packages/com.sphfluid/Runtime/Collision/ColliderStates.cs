using UnityEngine;

namespace SphFluid
{
    /// <summary>The states of colliders, and what has to be kept of those whose triangles do not follow from the collider alone.</summary>
    internal sealed class ColliderStates
    {
        /// <summary>What is read of meshes.</summary>
        public MeshReader Meshes { get; } = new MeshReader();

        /// <summary>What is read of terrains.</summary>
        public TerrainPatches Terrains { get; } = new TerrainPatches();

        /// <summary>The cylinders of wheels.</summary>
        public WheelDiscs Wheels { get; } = new WheelDiscs();

        /// <summary>The state of a collider.</summary>
        /// <param name="collider">The collider.</param>
        /// <param name="settings">Its Fluid Collider's; null for none.</param>
        /// <param name="friction">0 free slip to 1 no slip; negative: as the domain's faces.</param>
        /// <param name="worldToSimulation">World space to simulation space.</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        public ColliderState Get(Collider collider, IColliderSettings settings, float friction, in DomainPose worldToSimulation,
            Vector3 domain, float spacing)
        {
            if (WheelDiscs.IsWheel(collider)) return Wheels.StateOf(collider, settings, friction, worldToSimulation, spacing);
            ColliderState state = Terrains.StateOf(collider, friction, worldToSimulation, domain, spacing);
            return state.Mesh != null ? state.With(Meshes.EditionOf(state.Mesh)) : state;
        }
    }
}
