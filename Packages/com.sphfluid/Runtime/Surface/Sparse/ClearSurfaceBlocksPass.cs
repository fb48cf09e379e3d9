using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Resets the blocks: none is active and all counts are zero (Shaders/Surface/Sparse/ClearSurfaceBlocks.compute).</summary>
    internal sealed class ClearSurfaceBlocksPass : ComputePass
    {
        private static readonly int SurfaceNumber = Id("_SurfaceNumber");

        private readonly ComputeKernel kernel;

        public ClearSurfaceBlocksPass(FluidShaderSet shaders)
            : base(shaders, "ClearSurfaceBlocks")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="blocks">The blocks.</param>
        /// <param name="number">Stored among the counters: which recording they belong to.</param>
        public void Record(CommandBuffer cmd, SurfaceBlocks blocks, int number = 0)
        {
            using (Sample(cmd))
            {
                blocks.SetGlobals(cmd, kernel);
                kernel.SetInt(cmd, SurfaceNumber, number);
                kernel.Set(cmd, blocks.Table);
                kernel.Set(cmd, blocks.Counters);
                kernel.DispatchThreads(cmd, Math.Max(blocks.BlockCount, SurfaceCounters.Slots));
            }
        }
    }
}
