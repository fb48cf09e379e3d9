using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Slows all particles behind a step, for liquids that are to come to rest.</summary>
    internal sealed class DampVelocitiesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int Damping = Id("_Damping");

        private readonly ComputeKernel kernel;

        public DampVelocitiesPass(FluidShaderSet shaders)
            : base(shaders, "DampVelocities")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer to record into, behind a step.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="damping">Part of each velocity that is left, 0 to 1.</param>
        public void Record(CommandBuffer cmd, CellState state, float damping)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, Damping, damping);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
