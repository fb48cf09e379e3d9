using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The last motion of a step by its constraints, and velocities from displacements.</summary>
    internal sealed class FinishParticlesPass : ComputePass
    {
        private static readonly int InverseStep = Id("_InverseStep");
        private static readonly int PressureFactor = Id("_PressureFactor");
        private static readonly int IsMoved = Id("_IsMoved");

        private readonly ComputeKernel kernel;

        public FinishParticlesPass(FluidShaderSet shaders)
            : base(shaders, "FinishParticles")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step.</param>
        /// <param name="isMoved">Whether its only iteration has moved the particles already.</param>
        public void Record(CommandBuffer cmd, RobustState state, in FluidStep step, bool isMoved)
        {
            FluidSolverSettings settings = state.Settings;
            using (Sample(cmd))
            {
                RobustBindings.SetMotion(cmd, kernel, state, step.Length);
                kernel.SetFloat(cmd, InverseStep, 1f / step.Length);
                kernel.SetFloat(cmd, PressureFactor, settings.RestDensity / (step.Length * step.Length));
                kernel.SetBool(cmd, IsMoved, isMoved);
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
