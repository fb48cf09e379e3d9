using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Decides on the GPU whether the surface fits the buffers, and so how much is emitted and drawn; what does not fit
    /// leaves the last complete surface alone (Shaders/Surface/Sparse/SurfaceDrawArguments.compute).
    /// </summary>
    internal sealed class SurfaceDrawArgumentsPass : ComputePass
    {
        private static readonly int BlockCapacity = Id("_BlockCapacity");
        private static readonly int VertexCapacity = Id("_VertexCapacity");
        private static readonly int IndexCapacity = Id("_IndexCapacity");

        private readonly ComputeKernel kernel;

        public SurfaceDrawArgumentsPass(FluidShaderSet shaders)
            : base(shaders, "SurfaceDrawArguments")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks, SurfaceTriangles triangles) =>
            Record(cmd, blocks.Counters, blocks.Capacity, triangles.VertexCapacity, triangles.IndexCapacity, triangles);

        /// <summary>For capacities other than the buffers'.</summary>
        internal void Record(CommandBuffer cmd, FluidBuffer counters, int blockCapacity, int vertexCapacity,
            int indexCapacity, SurfaceTriangles triangles)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, BlockCapacity, blockCapacity);
                kernel.SetInt(cmd, VertexCapacity, vertexCapacity);
                kernel.SetInt(cmd, IndexCapacity, indexCapacity);
                kernel.Set(cmd, counters);
                kernel.Set(cmd, triangles.DrawArguments);
                kernel.Set(cmd, triangles.EmitArguments);
                kernel.DispatchThreads(cmd, 1);
            }
        }
    }
}
