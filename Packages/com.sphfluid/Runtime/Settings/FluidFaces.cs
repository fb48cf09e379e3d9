using System;

namespace SphFluid
{
    /// <summary>Faces of the domain box.</summary>
    [Flags]
    public enum FluidFaces
    {
        /// <summary>None.</summary>
        None = 0,

        /// <summary>The face at the low end of x.</summary>
        LowX = 1,

        /// <summary>The face at the high end of x.</summary>
        HighX = 2,

        /// <summary>The face at the low end of y: the floor, where the box stands upright.</summary>
        LowY = 4,

        /// <summary>The face at the high end of y.</summary>
        HighY = 8,

        /// <summary>The face at the low end of z.</summary>
        LowZ = 16,

        /// <summary>The face at the high end of z.</summary>
        HighZ = 32,

        /// <summary>All six.</summary>
        All = LowX | HighX | LowY | HighY | LowZ | HighZ,
    }
}
