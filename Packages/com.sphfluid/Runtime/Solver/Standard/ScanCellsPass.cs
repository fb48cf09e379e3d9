using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>First particle of each cell: an exclusive scan of the cells' counts in two dispatches (Shaders/Solver/Standard/ScanCells.compute).</summary>
    internal sealed class ScanCellsPass
    {
        /// <summary>Cells that a group sums; SCAN_CELLS_PER_GROUP in StandardTypes.hlsl.</summary>
        public const int CellsPerGroup = 2048;

        /// <summary>Most cells: each group sums up the groups before it, 2,048 at most.</summary>
        public const int MaxCells = CellsPerGroup * 2048;

        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("ScanCells");

        readonly ComputeKernel reduce;
        readonly ComputeKernel apply;

        public ScanCellsPass(FluidShaderSet shaders)
        {
            reduce = shaders.Kernel("ScanCells", "ScanReduce");
            apply = shaders.Kernel("ScanCells", "ScanApply");
        }

        /// <summary>Groups of a scan over that many state.Cells.</summary>
        public static int Groups(int cellCount) => (cellCount + CellsPerGroup - 1) / CellsPerGroup;

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            Bind(cmd, reduce, state);
            reduce.DispatchThreads(cmd, Groups(state.Standard.CellCount.count) * reduce.GroupSize.x);
            Bind(cmd, apply, state);
            apply.SetBuffer(cmd, StandardShaderIds.CellStartOut, state.Standard.CellStart);
            apply.DispatchThreads(cmd, Groups(state.Standard.CellCount.count) * apply.GroupSize.x);
            cmd.EndSample(Marker);
        }

        static void Bind(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            kernel.SetInt(cmd, StandardShaderIds.CellTotal, state.Standard.CellCount.count);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetBuffer(cmd, StandardShaderIds.CellCount, state.Standard.CellCount);
            kernel.SetBuffer(cmd, StandardShaderIds.BlockSum, state.Standard.BlockSum);
        }
    }
}
