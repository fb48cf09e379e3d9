namespace SphFluid
{
    /// <summary>What the blocks of the thesis method work on.</summary>
    internal sealed class ThesisState : FluidState
    {
        public ThesisState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false)
            : base(settings, particleCount, isPlanned)
        {
            try
            {
                Buffers = new ThesisBuffers(particleCount, isPlanned);
            }
            catch
            {
                base.Dispose();
                throw;
            }
        }

        /// <summary>The method's own buffers.</summary>
        public ThesisBuffers Buffers { get; }

        /// <summary>The constants that only this method has.</summary>
        public ThesisSettings Own => Settings.Own<ThesisSettings>();

        /// <inheritdoc/>
        protected override long OwnBytes => Buffers.Bytes;

        /// <inheritdoc/>
        public override void Dispose()
        {
            Buffers.Dispose();
            base.Dispose();
        }
    }
}
