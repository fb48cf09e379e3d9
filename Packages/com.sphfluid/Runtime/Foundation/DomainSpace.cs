using UnityEngine;

namespace SphFluid
{
    /// <summary>Simulation space: a pose in the world, without scale.</summary>
    internal static class DomainSpace
    {
        /// <summary>Simulation space to world space.</summary>
        public static Matrix4x4 ToWorld(Vector3 position, Quaternion rotation) => Matrix4x4.TRS(position, rotation, Vector3.one);

        /// <summary>World space to simulation space.</summary>
        public static Matrix4x4 FromWorld(Vector3 position, Quaternion rotation)
        {
            Quaternion inverse = Quaternion.Inverse(rotation);
            return Matrix4x4.TRS(inverse * -position, inverse, Vector3.one);
        }
    }
}
