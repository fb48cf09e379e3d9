namespace SphFluid
{
    /// <summary>What an implicit viscosity needs within a step; nothing is kept from one to the next.</summary>
    internal sealed class ViscousBuffers : BufferSet
    {
        /// <summary>Velocities, the last iterate [m/s].</summary>
        public readonly FluidBuffer Diffused;

        /// <summary>Velocities, the iterate before the last [m/s].</summary>
        public readonly FluidBuffer DiffusedBefore;

        /// <summary>The largest rate of the viscous matrix's rows [1/s], as bits, of this step and emptied for the next.</summary>
        public readonly FluidBuffer Spectrum;

        public ViscousBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            Diffused = Add("Diffused", particleCount, 16);
            DiffusedBefore = Add("DiffusedBefore", particleCount, 16);
            Spectrum = Add("Spectrum", 2, 4);
            Spectrum.SetData(new uint[2]);
        }

        /// <summary>Which of <see cref="Spectrum"/> the present step has, 0 or 1.</summary>
        public int Slot { get; private set; }

        /// <summary>Begins a step.</summary>
        public void NextSlot() => Slot = 1 - Slot;
    }
}
