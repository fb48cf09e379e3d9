using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Moves the particles by what an iteration, not the last, changed of the multipliers, and keeps them off walls.</summary>
    internal sealed class MoveByConstraintsPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public MoveByConstraintsPass(FluidShaderSet shaders)
            : base(shaders, "MoveByConstraints")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="isFirst">Whether it is the first iteration of the step.</param>
        public void Record(CommandBuffer cmd, RobustState state, float timeStep, bool isFirst)
        {
            using (Sample(cmd))
            {
                RobustBindings.SetMotion(cmd, kernel, state, timeStep, isFirst);
                kernel.Set(cmd, state.Buffers.Velocities);
                kernel.SetOut(cmd, state.Motion.Displacements);
                kernel.SetOut(cmd, state.Buffers.NewPositions);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
