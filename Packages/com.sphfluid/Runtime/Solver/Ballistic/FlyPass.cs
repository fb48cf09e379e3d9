using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A step of free flight; the faces of the domain stop what comes to them.</summary>
    internal sealed class FlyPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int TimeStep = Id("_TimeStep");
        private static readonly int KickStep = Id("_KickStep");
        private static readonly int Gravity = Id("_Gravity");
        private static readonly int DomainHalfSize = Id("_DomainHalfSize");

        private readonly ComputeKernel kernel;

        public FlyPass(FluidShaderSet shaders)
            : base(shaders, "Fly")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, BallisticState state, in FluidStep step)
        {
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, TimeStep, step.Length);
                kernel.SetFloat(cmd, KickStep, step.IsFirst ? 0.5f * step.Length : step.Kick);
                kernel.SetVector(cmd, Gravity, state.Settings.Gravity);
                kernel.SetVector(cmd, DomainHalfSize, 0.5f * state.Settings.DomainSize);
                kernel.Set(cmd, state.Published.Particles);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
