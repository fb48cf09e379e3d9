using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>How much liquid a box holds. A particle counts with the part that is in the box of a cube of a particle spacing, along the axes of the box.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidBoxResult
    {
        /// <summary>Volume of the liquid [m³].</summary>
        public float Volume;

        /// <summary>Volume over that of the box, at most 1: liquid at the bottom of a deep tank is compressed by about a hundredth.</summary>
        public float Fill;

        internal uint Count;
        internal uint Generation;
        internal Vector4 Unused;

        /// <summary>Particles whose centre is in the box.</summary>
        public int Particles => (int)Count;
    }
}
