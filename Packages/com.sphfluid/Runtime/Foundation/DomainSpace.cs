using UnityEngine;

namespace SphFluid
{
    /// <summary>Simulation space: a pose in the world, without scale.</summary>
    internal static class DomainSpace
    {
        /// <summary>Simulation space to world space.</summary>
        public static Matrix4x4 ToWorld(Vector3 position, Quaternion rotation) => Matrix4x4.TRS(position, rotation, Vector3.one);

        /// <summary>Whether a place of simulation space is in a domain; one that is not finite is not.</summary>
        /// <param name="place">The place [m].</param>
        /// <param name="size">Edge lengths of the domain [m].</param>
        public static bool Holds(Vector3 place, Vector3 size) =>
            Mathf.Abs(place.x) <= 0.5f * size.x && Mathf.Abs(place.y) <= 0.5f * size.y && Mathf.Abs(place.z) <= 0.5f * size.z;

        /// <summary>World space to simulation space.</summary>
        public static DomainPose FromWorld(Vector3 position, Quaternion rotation) =>
            new DomainPose(position, Matrix4x4.Rotate(Quaternion.Inverse(rotation)));
    }
}
