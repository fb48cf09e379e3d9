using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// First slot and number of the slots that the next dispatches work on (Shaders/Surface/Sparse/ListSurfaceBlocks.compute): those of the blocks that
    /// particles marked, or of those listed since.
    /// </summary>
    sealed class BeginSurfaceRoundPass
    {
        const string Name = "BeginSurfaceRound";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);
        static readonly int LateRound = Shader.PropertyToID("_LateRound");

        readonly ComputeKernel kernel;

        public BeginSurfaceRoundPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("ListSurfaceBlocks", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks, bool late)
        {
            cmd.BeginSample(Marker);
            blocks.SetGlobals(cmd, kernel);
            kernel.SetBool(cmd, LateRound, late);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, blocks.Counters);
            kernel.SetBuffer(cmd, SparseShaderIds.RoundArguments, blocks.RoundArguments);
            kernel.DispatchThreads(cmd, 1);
            cmd.EndSample(Marker);
        }
    }
}
