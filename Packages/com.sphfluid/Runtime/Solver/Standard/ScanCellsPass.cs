using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>First particle of each cell: an exclusive scan of the cells' counts in two dispatches.</summary>
    internal sealed class ScanCellsPass : ComputePass
    {
        static readonly int CellTotal = Id("_CellTotal");
        static readonly int ParticleCount = Id("_ParticleCount");

        readonly ComputeKernel reduce, apply;

        public ScanCellsPass(FluidShaderSet shaders)
            : base(shaders, "ScanCells")
        {
            reduce = Kernel("ScanReduce");
            apply = Kernel("ScanApply");
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            using (Sample(cmd))
            {
                int groups = CellRows.ScanGroups(state.Buffers.CellCount.Count);
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
