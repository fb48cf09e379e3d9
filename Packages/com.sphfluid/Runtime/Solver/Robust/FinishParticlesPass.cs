using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The last motion of a step by its constraints, and velocities from displacements.</summary>
    internal sealed class FinishParticlesPass : ComputePass
    {
        private static readonly int InverseStep = Id("_InverseStep");
        private static readonly int PressureFactor = Id("_PressureFactor");

        private readonly ComputeKernel first, later;

        public FinishParticlesPass(FluidShaderSet shaders)
            : base(shaders, "FinishParticles")
        {
            first = Kernel("FinishFirst");
            later = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step.</param>
        /// <param name="iterations">Its iterations.</param>
        public void Record(CommandBuffer cmd, RobustState state, in FluidStep step, int iterations)
        {
            FluidSolverSettings settings = state.Settings;
            ComputeKernel kernel = iterations == 1 ? first : later;
            using (Sample(cmd))
            {
                RobustBindings.SetMotion(cmd, kernel, state, step.Length);
                if (iterations == 1) RobustBindings.SetDrag(cmd, kernel, state, step.Length, iterations);
                kernel.SetFloat(cmd, InverseStep, 1f / step.Length);
                kernel.SetFloat(cmd, PressureFactor, settings.RestDensity / (step.Length * step.Length));
                kernel.Set(cmd, state.Motion.Displacements);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                CellBindings.SetCounting(cmd, kernel, state, step);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
