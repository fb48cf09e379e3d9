using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Moves the particles by what an iteration, not the last, changed of the multipliers, and keeps them off walls.</summary>
    internal sealed class MoveByConstraintsPass : ComputePass
    {
        private readonly ComputeKernel first, later;

        public MoveByConstraintsPass(FluidShaderSet shaders)
            : base(shaders, "MoveByConstraints")
        {
            first = Kernel("MoveFirst");
            later = Kernel();
        }

        /// <summary>The first iteration of a step, with what acts on velocities.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="iterations">Its iterations.</param>
        public void RecordFirst(CommandBuffer cmd, RobustState state, float timeStep, int iterations)
        {
            using (Sample(cmd))
            {
                RobustBindings.SetDrag(cmd, first, state, timeStep, iterations);
                Dispatch(cmd, first, state, timeStep);
            }
        }

        /// <summary>A later one.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        public void Record(CommandBuffer cmd, RobustState state, float timeStep)
        {
            using (Sample(cmd)) Dispatch(cmd, later, state, timeStep);
        }

        private static void Dispatch(CommandBuffer cmd, ComputeKernel kernel, RobustState state, float timeStep)
        {
            RobustBindings.SetMotion(cmd, kernel, state, timeStep);
            kernel.SetOut(cmd, state.Motion.Displacements);
            kernel.SetOut(cmd, state.Buffers.NewPositions);
            kernel.Set(cmd, state.Published.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
        }
    }
}
