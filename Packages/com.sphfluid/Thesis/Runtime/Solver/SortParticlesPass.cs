using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.6: the particles in the order of their cells, written to the second buffer; the two are exchanged.</summary>
    internal sealed class SortParticlesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");

        private readonly ComputeKernel kernel;

        public SortParticlesPass(FluidShaderSet shaders)
            : base(shaders, "SortParticles")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.Set(cmd, state.Buffers.Grid);
                kernel.Set(cmd, state.Published.Particles);
                kernel.Set(cmd, state.Buffers.SortedParticles);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }

            FluidBuffer.Exchange(state.Published.Particles, state.Buffers.SortedParticles);
        }
    }
}
