namespace SphFluid
{
    /// <summary>The ways to compute the liquid's motion.</summary>
    public enum FluidMethodKind
    {
        /// <summary>Figueroa's thesis (2012), corrected: Müller's kernels, bitonic sort, one time step after another.</summary>
        Thesis = 0,

        /// <summary>The thesis's text as printed, as far as it can run (<see cref="ThesisSwitches.Printed"/>): for comparison, not for use.</summary>
        ThesisPrinted = 1,

        /// <summary>Weakly compressible SPH with one kernel, walls that carry density, and a counting sort: faster, more accurate, the default.</summary>
        Standard = 2,
    }
}
