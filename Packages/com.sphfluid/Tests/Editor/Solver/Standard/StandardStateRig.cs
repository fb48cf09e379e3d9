namespace SphFluid.Tests
{
    /// <summary>Buffers of the Standard method that a test fills by itself, to run one pass on them.</summary>
    internal sealed class StandardStateRig : CellStateRig<StandardState>
    {
        public StandardStateRig(in FluidSolverSettings settings, int particleCount) : base(new StandardState(settings, particleCount))
        {
        }
    }
}
