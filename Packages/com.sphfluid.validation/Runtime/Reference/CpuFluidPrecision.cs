namespace SphFluid.Validation
{
    /// <summary>In what a <see cref="CpuFluidSolver"/> keeps its numbers between the blocks; sums and products are always double.</summary>
    public enum CpuFluidPrecision
    {
        /// <summary>Every stored value is rounded to float, as the GPU's buffers hold it: shows what storage alone costs.</summary>
        Single = 0,

        /// <summary>Nothing is rounded to float: the oracle.</summary>
        Double = 1,
    }
}
