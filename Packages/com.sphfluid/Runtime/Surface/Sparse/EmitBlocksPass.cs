using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Vertices and triangles of all blocks, a group each (Shaders/Surface/Sparse/EmitBlocks.compute).
    /// </summary>
    internal sealed class EmitBlocksPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public EmitBlocksPass(FluidShaderSet shaders)
            : base(shaders, "EmitBlocks")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, in SurfaceInput input, FluidBuffer tables, SurfaceTriangles triangles)
        {
            using (Sample(cmd))
            {
                input.SetPolygons(cmd, kernel, tables);
                kernel.Set(cmd, triangles.Vertices);
                kernel.Set(cmd, triangles.Indices);
                kernel.DispatchIndirect(cmd, triangles.EmitArguments);
            }
        }
    }
}
