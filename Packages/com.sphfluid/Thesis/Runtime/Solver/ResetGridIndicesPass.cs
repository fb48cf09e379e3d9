using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.4: every cell is empty.</summary>
    internal sealed class ResetGridIndicesPass : ComputePass
    {
        private static readonly int CellCount = Id("_CellCount");

        private readonly ComputeKernel kernel;

        public ResetGridIndicesPass(FluidShaderSet shaders)
            : base(shaders, "ResetGridIndices")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, CellCount, state.Grid.CellCount);
                kernel.Set(cmd, state.Published.GridIndices);
                kernel.DispatchThreads(cmd, state.Grid.CellCount);
            }
        }
    }
}
