using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Gives marked blocks slots, one atomic operation a group of 256 blocks, and says which slots the next dispatches
    /// work on (Shaders/Surface/Sparse/ListSurfaceBlocks.compute).
    /// </summary>
    internal sealed class ListSurfaceBlocksPass : ComputePass
    {
        private static readonly int LateRound = Id("_LateRound");

        private readonly ComputeKernel list;
        private readonly ComputeKernel beginRound;

        public ListSurfaceBlocksPass(FluidShaderSet shaders)
            : base(shaders, "ListSurfaceBlocks")
        {
            list = Kernel();
            beginRound = Kernel("BeginSurfaceRound");
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks)
        {
            using (Sample(cmd))
            {
                blocks.SetGlobals(cmd, list);
                list.Set(cmd, blocks.Table);
                list.Set(cmd, blocks.List);
                list.Set(cmd, blocks.Counters);
                list.DispatchThreads(cmd, blocks.BlockCount);
            }
        }

        /// <summary>
        /// First slot and number of slots of a round. The first round has the blocks that particles marked, the late
        /// one those that were listed since.
        /// </summary>
        public void RecordRound(CommandBuffer cmd, SurfaceBlocks blocks, bool late)
        {
            using (Sample(cmd))
            {
                blocks.SetGlobals(cmd, beginRound);
                beginRound.SetBool(cmd, LateRound, late);
                beginRound.Set(cmd, blocks.Counters);
                beginRound.Set(cmd, blocks.RoundArguments);
                beginRound.DispatchThreads(cmd, 1);
            }
        }
    }
}
