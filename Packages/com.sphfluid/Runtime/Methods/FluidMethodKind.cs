namespace SphFluid
{
    /// <summary>The ways to compute the liquid's motion.</summary>
    public enum FluidMethodKind
    {
        /// <summary>Figueroa's thesis (2012): Müller's kernels, bitonic sort, one time step after another.</summary>
        Thesis = 0,
    }
}
