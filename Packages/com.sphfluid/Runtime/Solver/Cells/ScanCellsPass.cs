using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>First particle of each cell: an exclusive scan of the cells' counts, whose sums are there.</summary>
    internal sealed class ScanCellsPass : ComputePass
    {
        private static readonly int CellTotal = Id("_CellTotal");

        private readonly ComputeKernel kernel;

        public ScanCellsPass(FluidShaderSet shaders)
            : base(shaders, "ScanCells")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, CellState state)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, CellTotal, state.Buffers.CellTotal);
                kernel.SetOut(cmd, state.Buffers.CellCount);
                kernel.DispatchThreads(cmd, CellRows.ScanGroups(state.Buffers.CellTotal) * kernel.GroupSize.x);
            }
        }
    }
}
