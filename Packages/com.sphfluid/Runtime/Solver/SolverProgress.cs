namespace SphFluid
{
    /// <summary>How far a liquid has come.</summary>
    internal struct SolverProgress
    {
        /// <summary>Steps since the start.</summary>
        public long StepCount;

        /// <summary>Their time [s].</summary>
        public double SimulatedTime;

        /// <summary>Length of the last step [s].</summary>
        public float PreviousStep;

        /// <summary>Number that a particle gets that comes next, where nothing has come or gone yet.</summary>
        public uint NextId;

        /// <summary>What was counted.</summary>
        public FluidCounters Counters;
    }
}
