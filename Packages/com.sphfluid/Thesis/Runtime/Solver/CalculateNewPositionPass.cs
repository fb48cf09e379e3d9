using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.4: leapfrog, equations (19) to (21).</summary>
    internal sealed class CalculateNewPositionPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int TimeStep = Id("_TimeStep");
        private static readonly int KickStep = Id("_KickStep");
        private static readonly int KickPart = Id("_KickPart");
        private static readonly int FirstStep = Id("_FirstStep");
        private static readonly int DomainHalfSize = Id("_DomainHalfSize");

        private readonly ComputeKernel kernel;

        public CalculateNewPositionPass(FluidShaderSet shaders)
            : base(shaders, "CalculateNewPosition")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            ThesisSettings own = state.Own;
            using (Sample(cmd))
            {
                DomainBindings.SetPeriodic(cmd, kernel, settings);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, TimeStep, step.Length);
                kernel.SetFloat(cmd, KickStep, step.Kick);
                kernel.SetFloat(cmd, KickPart, step.KickPart);
                kernel.SetBool(cmd, FirstStep, step.IsFirst && own.HalfKick);
                kernel.SetVector(cmd, DomainHalfSize, 0.5f * settings.DomainSize);
                kernel.Set(cmd, state.Published.Particles);
                kernel.Set(cmd, state.Buffers.Acceleration);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
