using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.2: the pair (cell, id) of each particle, padded to the power of two that the sort needs.</summary>
    internal sealed class CalculateParticleCellValuePass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int PaddedCount = Id("_PaddedCount");

        private readonly ComputeKernel kernel;

        public CalculateParticleCellValuePass(FluidShaderSet shaders)
            : base(shaders, "CalculateParticleCellValue")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            using (Sample(cmd))
            {
                GridNeighbours.SetGrid(cmd, kernel, state.Grid);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetInt(cmd, PaddedCount, state.Buffers.PaddedCount);
                kernel.Set(cmd, state.Published.Particles);
                kernel.Set(cmd, state.Buffers.Grid);
                kernel.DispatchThreads(cmd, state.Buffers.PaddedCount);
            }
        }
    }
}
