using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Solves for the velocities behind an implicit viscosity by a number of iterations that is known when they are recorded: nothing is
    /// read back.
    /// </summary>
    internal sealed class DiffuseVelocitiesPass : ComputePass
    {
        private static readonly int PairRate = Id("_PairRate");
        private static readonly int SpectrumSlot = Id("_SpectrumSlot");
        private static readonly int ZeroShare = Id("_ZeroShare");
        private static readonly int Iteration = Id("_Iteration");

        private readonly ComputeKernel begin, next;

        public DiffuseVelocitiesPass(FluidShaderSet shaders)
            : base(shaders, "DiffuseVelocities")
        {
            begin = Kernel("BeginDiffusion");
            next = Kernel();
        }

        /// <summary>Records a step's iterations.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers; the solution is in <see cref="ViscousBuffers.Diffused"/>.</param>
        /// <param name="step">The step.</param>
        /// <param name="iterations">Their number, 2 or more; 0 for what the step needs.</param>
        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step, int iterations = 0)
        {
            ViscousBuffers viscous = state.Viscous;
            if (iterations == 0) iterations = ImplicitViscosity.Iterations(state.Settings, MotionBindings.KickOf(step));
            using (Sample(cmd))
            {
                Bind(cmd, begin, state, step, iterations);
                begin.SetBuffer(cmd, viscous.Diffused.Id, state.Buffers.Velocities);
                begin.SetOut(cmd, viscous.Diffused);
                begin.Set(cmd, viscous.DiffusedBefore);
                begin.DispatchThreads(cmd, state.ParticleCount);
                Bind(cmd, next, state, step, iterations);
                for (int i = 1; i < iterations; i++)
                {
                    next.SetInt(cmd, Iteration, i);
                    next.Set(cmd, viscous.Diffused);
                    next.Set(cmd, viscous.DiffusedBefore);
                    next.DispatchThreads(cmd, state.ParticleCount);
                    FluidBuffer.Exchange(viscous.Diffused, viscous.DiffusedBefore);
                }
            }
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step, int iterations)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            MotionBindings.SetWalls(cmd, kernel, state, step);
            state.List.Set(cmd, kernel);
            kernel.SetFloat(cmd, PairRate, (float)MotionBindings.PairRate(state.Settings));
            kernel.SetFloat(cmd, ZeroShare, (float)ImplicitViscosity.ZeroShare(iterations));
            kernel.SetInt(cmd, SpectrumSlot, state.Viscous.Slot);
            kernel.Set(cmd, state.Viscous.Spectrum);
            kernel.Set(cmd, state.Buffers.NewVelocities);
        }
    }
}
