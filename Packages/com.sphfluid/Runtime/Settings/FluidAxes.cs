using System;

namespace SphFluid
{
    /// <summary>Axes of the domain box.</summary>
    [Flags]
    public enum FluidAxes
    {
        /// <summary>None.</summary>
        None = 0,

        /// <summary>The box's x.</summary>
        X = 1,

        /// <summary>The box's y.</summary>
        Y = 2,

        /// <summary>The box's z.</summary>
        Z = 4,

        /// <summary>All three.</summary>
        All = X | Y | Z,
    }
}
