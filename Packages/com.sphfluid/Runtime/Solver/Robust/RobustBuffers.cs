namespace SphFluid
{
    /// <summary>Buffers that only the Robust method has.</summary>
    internal sealed class RobustBuffers : BufferSet
    {
        /// <summary>Where the substep began, in the order of its sort [m]; w: pressure of the substep before [Pa].</summary>
        public readonly FluidBuffer Starts;

        /// <summary>The same as the step before leaves it, before the sort.</summary>
        public readonly FluidBuffer NewStarts;

        /// <summary>How far each particle has come from there [m]; w: the id's bits.</summary>
        public readonly FluidBuffer Displacements;

        public RobustBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            Starts = AddForEach("Starts", particleCount, 16);
            NewStarts = AddForEach("NewStarts", particleCount, 16);
            Displacements = AddForEach("Displacements", particleCount, 16);
        }
    }
}
