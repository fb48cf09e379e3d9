namespace SphFluid
{
    /// <summary>What the ballistic method works on: what readers see, and no more.</summary>
    internal sealed class BallisticState : FluidState
    {
        public BallisticState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false)
            : base(settings, particleCount, isPlanned)
        {
        }

        /// <inheritdoc/>
        protected override long OwnBytes => 0;
    }
}
