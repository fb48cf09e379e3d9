using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.5: first and end of each cell's run in the sorted pairs.</summary>
    internal sealed class SetGridIndicesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("SetGridIndices");

        readonly ComputeKernel kernel;

        public SetGridIndicesPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("SetGridIndices", "SetGridIndices");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetBuffer(cmd, FluidShaderIds.Grid, state.Thesis.Grid);
            kernel.SetBuffer(cmd, FluidShaderIds.GridIndices, state.Buffers.GridIndices);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
