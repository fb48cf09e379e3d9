using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Where forces from outside would take the particles in a step, and the count of the cells there.</summary>
    internal sealed class PredictParticlesPass : ComputePass
    {
        private static readonly int IsLeft = Id("_IsLeft");
        private static readonly int Gravity = Id("_Gravity");

        private readonly ComputeKernel kernel;

        public PredictParticlesPass(FluidShaderSet shaders)
            : base(shaders, "PredictParticles")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step; a sort follows whatever it says.</param>
        /// <param name="isLeft">Whether particles stand as a step left them, not sorted at their present places.</param>
        public void Record(CommandBuffer cmd, RobustState state, in FluidStep step, bool isLeft)
        {
            FluidSolverSettings settings = state.Settings;
            using (Sample(cmd))
            {
                CellBindings.SetSearch(cmd, kernel, state);
                CellBindings.SetWalls(cmd, kernel, state);
                CellBindings.SetShell(cmd, kernel, settings, step.Length);
                DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
                ForceZones.Set(cmd, kernel, state.Zones, settings.SupportRadius);
                kernel.SetVector(cmd, Gravity, settings.Gravity);
                kernel.SetFloat(cmd, CellBindings.KickStep, step.IsFirst ? 0.5f * step.Length : step.Kick);
                kernel.SetBool(cmd, IsLeft, isLeft);
                kernel.Set(cmd, state.Buffers.Positions);
                kernel.Set(cmd, state.Buffers.Velocities);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                if (state.HasBodies) kernel.SetOut(cmd, state.Walls.Contacts);
                CellBindings.SetCounting(cmd, kernel, state, step);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
