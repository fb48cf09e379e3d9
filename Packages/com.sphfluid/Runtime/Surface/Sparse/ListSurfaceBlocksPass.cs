using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Gives marked blocks slots, one atomic operation a group of 256 blocks (Shaders/Surface/Sparse/ListSurfaceBlocks.compute).</summary>
    sealed class ListSurfaceBlocksPass
    {
        const string Name = "ListSurfaceBlocks";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public ListSurfaceBlocksPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("ListSurfaceBlocks", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks)
        {
            cmd.BeginSample(Marker);
            blocks.SetGlobals(cmd, kernel);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockTable, blocks.Table);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockList, blocks.List);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, blocks.Counters);
            kernel.DispatchThreads(cmd, blocks.BlockCount);
            cmd.EndSample(Marker);
        }
    }
}
