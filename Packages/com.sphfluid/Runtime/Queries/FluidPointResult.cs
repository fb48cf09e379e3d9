using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the liquid is at a point: sums of Wendland's C2 kernel over the particles within the support radius.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidPointResult
    {
        /// <summary>Bytes, as in Shaders/Queries/AnswerPoints.compute.</summary>
        internal const int Stride = 32;

        /// <summary>Mean velocity of the particles around in world space [m/s]; 0 where there are none.</summary>
        public Vector3 Velocity;

        /// <summary>
        /// Density [kg/m³] by summation over the kernel's part inside the domain: near the rest density within liquid, half of it at the
        /// surface, 0 without liquid.
        /// </summary>
        public float Density;

        /// <summary>Mean pressure of the particles around [Pa]. Noisy: average it over time.</summary>
        public float Pressure;

        internal uint Generation;
        internal uint Wet;
        internal uint Pad;

        /// <summary>Whether the point is in the liquid: the density is above half the rest density.</summary>
        public bool IsWet => Wet != 0;
    }
}
