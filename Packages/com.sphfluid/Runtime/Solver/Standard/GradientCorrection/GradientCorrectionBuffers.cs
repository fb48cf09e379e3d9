namespace SphFluid
{
    /// <summary>What the gradient correction keeps from step to step, and needs at a sort.</summary>
    internal sealed class GradientCorrectionBuffers : BufferSet, ICarriedBuffers
    {
        private const int MomentStride = 24;

        /// <summary>B − 1 of each particle as six half floats, of the last sort, and the offset of its density [kg/m³].</summary>
        public readonly FluidBuffer Corrections;

        /// <summary>The same in the order of the next sort.</summary>
        public readonly FluidBuffer SortedCorrections;

        /// <summary>A of each particle at the last sort.</summary>
        public readonly FluidBuffer Moments;

        public GradientCorrectionBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            Corrections = Add("Corrections", particleCount, 16);
            SortedCorrections = Add("SortedCorrections", particleCount, 16);
            Moments = Add("Moments", particleCount, MomentStride);
            if (!isPlanned) Corrections.SetData(new uint[4 * particleCount]); // no offset is known yet
        }

        FluidBuffer ICarriedBuffers.Carried => Corrections;

        FluidBuffer ICarriedBuffers.Sorted => SortedCorrections;
    }
}
