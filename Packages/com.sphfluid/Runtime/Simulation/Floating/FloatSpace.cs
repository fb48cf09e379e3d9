using UnityEngine;

namespace SphFluid
{
    /// <summary>World space and simulation space, for what a Rigidbody says of itself.</summary>
    internal readonly struct FloatSpace
    {
        /// <param name="position">World position of the domain's centre [m].</param>
        /// <param name="rotation">World rotation of the domain.</param>
        public FloatSpace(Vector3 position, Quaternion rotation)
        {
            Position = position;
            ToWorld = rotation;
            ToSimulation = Quaternion.Inverse(rotation);
        }

        /// <summary>World position of the domain's centre [m].</summary>
        public Vector3 Position { get; }

        /// <summary>Rotation of simulation space to the world.</summary>
        public Quaternion ToWorld { get; }

        /// <summary>Rotation of the world to simulation space.</summary>
        public Quaternion ToSimulation { get; }
    }
}
