using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How much liquid a box holds. A particle counts with the part that is in the box of a cube of a particle spacing, along the axes of
    /// the box.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidBoxResult
    {
        /// <summary>Volume of the liquid [m³]: that of its particles as emitters, drains and fills count them.</summary>
        public float Volume;

        /// <summary>
        /// Part of the box that the liquid takes once it is at rest, at most 1. At rest it has its density by mass, m/ρ0 a particle: about
        /// a fiftieth less than <see cref="Volume"/>, which is that of the lattice from which it came.
        /// </summary>
        public float Fill;

        internal uint Count;
        internal uint Generation;
        internal Vector4 Unused;

        /// <summary>Particles whose centre is in the box.</summary>
        public int Particles => (int)Count;
    }
}
