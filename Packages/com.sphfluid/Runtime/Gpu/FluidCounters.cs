namespace SphFluid
{
    /// <summary>What the GPU counted while it stepped, as of the last finished read-back (a few frames old).</summary>
    public struct FluidCounters
    {
        /// <summary>Times the emergency acceleration limit cut a particle's acceleration, since the start.</summary>
        public long AccelerationLimitHits;

        /// <summary>Times a particle was put back onto a face of the domain box, since the start.</summary>
        public long DomainClamps;

        /// <summary>Times a particle's position or velocity was not a finite number, since the start; it was stopped where it had been.</summary>
        public long NonFinite;

        /// <summary>Largest speed in the last recorded steps [m/s].</summary>
        public float MaxSpeed;

        /// <summary>Largest density in the last recorded steps over the rest density, minus one; 0.04 is 4 % compression.</summary>
        public float MaxCompression;
    }
}
