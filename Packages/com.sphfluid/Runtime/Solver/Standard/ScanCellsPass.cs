using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>First particle of each cell: an exclusive scan of the cells' counts in two dispatches.</summary>
    internal sealed class ScanCellsPass : ComputePass
    {
        /// <summary>Cells that a group sums; SCAN_CELLS_PER_GROUP in StandardTypes.hlsl.</summary>
        public const int CellsPerGroup = 2048;

        /// <summary>Most cells: each group sums up the groups before it, 2,048 at most.</summary>
        public const int MaxCells = CellsPerGroup * 2048;

        static readonly int CellTotal = Id("_CellTotal");
        static readonly int ParticleCount = Id("_ParticleCount");

        readonly ComputeKernel reduce, apply;

        public ScanCellsPass(FluidShaderSet shaders)
            : base(shaders, "ScanCells")
        {
            reduce = Kernel("ScanReduce");
            apply = Kernel("ScanApply");
        }

        /// <summary>Groups of a scan over that many cells.</summary>
        public static int Groups(int cellCount) => (cellCount + CellsPerGroup - 1) / CellsPerGroup;

        public void Record(CommandBuffer cmd, StandardState state)
        {
            using (Sample(cmd))
            {
                int groups = Groups(state.Buffers.CellCount.Count);
                Bind(cmd, reduce, state);
                reduce.DispatchThreads(cmd, groups * reduce.GroupSize.x);
                Bind(cmd, apply, state);
                apply.SetOut(cmd, state.Buffers.CellStart);
                apply.DispatchThreads(cmd, groups * apply.GroupSize.x);
            }
        }

        static void Bind(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
            kernel.SetInt(cmd, CellTotal, state.Buffers.CellCount.Count);
            kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
            kernel.Set(cmd, state.Buffers.CellCount);
            kernel.Set(cmd, state.Buffers.BlockSum);
        }
    }
}
