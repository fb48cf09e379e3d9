using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Vertices and indices of the present round's blocks, a group each, and their place in the buffers. Lists blocks
    /// that the surface reaches though no particle marked them (Shaders/Surface/Sparse/CountBlocks.compute).
    /// </summary>
    internal sealed class CountBlocksPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public CountBlocksPass(FluidShaderSet shaders)
            : base(shaders, "CountBlocks")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, in SurfaceInput input, FluidBuffer tables)
        {
            using (Sample(cmd))
            {
                input.SetPolygons(cmd, kernel, tables);
                kernel.DispatchIndirect(cmd, input.Blocks.RoundArguments);
            }
        }
    }
}
