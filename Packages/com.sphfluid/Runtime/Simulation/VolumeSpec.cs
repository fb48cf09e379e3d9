using UnityEngine;

namespace SphFluid
{
    /// <summary>What a liquid volume fills: the values of its component and its transform.</summary>
    internal struct VolumeSpec
    {
        /// <summary>The component, the context of messages.</summary>
        public Component Owner;

        /// <summary>World position [m].</summary>
        public Vector3 Position;

        /// <summary>World rotation.</summary>
        public Quaternion Rotation;

        /// <summary>The volume's space to world space, with scale.</summary>
        public Matrix4x4 LocalToWorld;

        public FluidVolumeShape Shape;
        public Vector3 Size;

        /// <summary>The mesh that shape Mesh fills; null when there is none.</summary>
        public Mesh FilledMesh;

        public float Level;
        public bool DomainHolds;

        /// <summary>Velocity at the start in the volume's axes [m/s].</summary>
        public Vector3 InitialVelocity;

        /// <summary>The owner's name.</summary>
        public readonly string Name => Owner.name;
    }
}
