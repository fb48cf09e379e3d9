using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.5: first and end of each cell's run in the sorted pairs.</summary>
    internal sealed class SetGridIndicesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");

        private readonly ComputeKernel kernel;

        public SetGridIndicesPass(FluidShaderSet shaders)
            : base(shaders, "SetGridIndices")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.Set(cmd, state.Buffers.Grid);
                kernel.Set(cmd, state.Published.GridIndices);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
