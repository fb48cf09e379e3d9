using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.6: the particles in the order of their cells, written to the second buffer; the two are exchanged.</summary>
    internal sealed class SortParticlesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("SortParticles");

        readonly ComputeKernel kernel;

        public SortParticlesPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("SortParticles", "SortParticles");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetBuffer(cmd, FluidShaderIds.Grid, state.Thesis.Grid);
            kernel.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            kernel.SetBuffer(cmd, FluidShaderIds.SortedParticles, state.Thesis.SortedParticles);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
            state.Thesis.SwapParticles(state.Buffers);
        }
    }
}
