using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Where a ray meets the liquid's surface: the density is half the rest density there, as <see cref="FluidPointResult.Density"/> has
    /// it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidRayResult
    {
        /// <summary>World position of the surface [m]; the ray's origin where it meets none.</summary>
        public Vector3 Place;

        /// <summary>Distance from the ray's origin [m]: 0 of a ray that begins in liquid, −1 of one that meets none.</summary>
        public float Distance;

        /// <summary>Unit normal of the surface in world space, out of the liquid; of a ray that begins in liquid it means little.</summary>
        public Vector3 Normal;

        internal uint Generation;

        /// <summary>Whether the ray meets liquid.</summary>
        public bool IsHit => Distance >= 0f;
    }
}
