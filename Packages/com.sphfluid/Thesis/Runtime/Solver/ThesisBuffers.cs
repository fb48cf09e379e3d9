namespace SphFluid
{
    /// <summary>The structured buffers of thesis 6.2.1 that only its own blocks use, and those that the sort needs.</summary>
    internal sealed class ThesisBuffers : BufferSet
    {
        /// <summary>Target of the next SortParticles; it is then exchanged with the liquid's particles.</summary>
        public readonly FluidBuffer SortedParticles;

        /// <summary>Pairs (cell, id), uint2.</summary>
        public readonly FluidBuffer Grid;

        /// <summary>The pairs as a transposed matrix, while they are sorted.</summary>
        public readonly FluidBuffer GridTranspose;

        /// <summary>Force density on each particle [N/m³], float4, w unused.</summary>
        public readonly FluidBuffer Force;

        /// <summary>Acceleration of each particle [m/s²], float4, w unused.</summary>
        public readonly FluidBuffer Acceleration;

        public ThesisBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            PaddedCount = BitonicSortPass.PaddedCount(particleCount);
            SortedParticles = Add("SortedParticles", particleCount, FluidParticle.Stride);
            Grid = Add("Grid", PaddedCount, 2 * sizeof(uint));
            GridTranspose = Add("GridTranspose", PaddedCount, 2 * sizeof(uint));
            Force = Add("Force", particleCount, 4 * sizeof(float));
            Acceleration = Add("Acceleration", particleCount, 4 * sizeof(float));
        }

        /// <summary>Number of sorted pairs: the next power of two, 1,024 at least.</summary>
        public int PaddedCount { get; }
    }
}
