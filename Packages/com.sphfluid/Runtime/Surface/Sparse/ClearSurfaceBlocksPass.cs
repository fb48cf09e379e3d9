using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>No block is active, nothing is counted (Shaders/Surface/Sparse/ClearSurfaceBlocks.compute).</summary>
    sealed class ClearSurfaceBlocksPass : ComputePass
    {
        readonly ComputeKernel kernel;

        public ClearSurfaceBlocksPass(FluidShaderSet shaders)
            : base(shaders, "ClearSurfaceBlocks")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks)
        {
            using (Sample(cmd))
            {
                blocks.SetGlobals(cmd, kernel);
                kernel.Set(cmd, blocks.Table);
                kernel.Set(cmd, blocks.Counters);
                kernel.DispatchThreads(cmd, Math.Max(blocks.BlockCount, SurfaceCounters.Slots));
            }
        }
    }
}
