using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.2: the pair (cell, id) of each particle, padded to the power of two that the sort needs.</summary>
    internal sealed class CalculateParticleCellValuePass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("CalculateParticleCellValue");

        readonly ComputeKernel kernel;

        public CalculateParticleCellValuePass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CalculateParticleCellValue", "CalculateParticleCellValue");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            GridNeighbours.SetGrid(cmd, kernel, state.Grid);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetInt(cmd, FluidShaderIds.PaddedCount, state.Thesis.PaddedCount);
            kernel.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            kernel.SetBuffer(cmd, FluidShaderIds.Grid, state.Thesis.Grid);
            kernel.DispatchThreads(cmd, state.Thesis.PaddedCount);
            cmd.EndSample(Marker);
        }
    }
}
