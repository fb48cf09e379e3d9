using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Holds all speeds behind a step at or below a limit.</summary>
    internal sealed class LimitVelocitiesPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int LargestSpeed = Id("_LargestSpeed");

        private readonly ComputeKernel kernel;

        public LimitVelocitiesPass(FluidShaderSet shaders)
            : base(shaders, "LimitVelocities")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer to record into, behind a step.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="speed">Largest speed [m/s].</param>
        public void Record(CommandBuffer cmd, StandardState state, float speed)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, LargestSpeed, speed);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
