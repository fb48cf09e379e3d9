using System;
using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>No block is active, nothing is counted (Shaders/Surface/Sparse/ClearSurfaceBlocks.compute).</summary>
    sealed class ClearSurfaceBlocksPass
    {
        const string Name = "ClearSurfaceBlocks";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public ClearSurfaceBlocksPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("ClearSurfaceBlocks", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks)
        {
            cmd.BeginSample(Marker);
            blocks.SetGlobals(cmd, kernel);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockTable, blocks.Table);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, blocks.Counters);
            kernel.DispatchThreads(cmd, Math.Max(blocks.BlockCount, SurfaceCounters.Slots));
            cmd.EndSample(Marker);
        }
    }
}
