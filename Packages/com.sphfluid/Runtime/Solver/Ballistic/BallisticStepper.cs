using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Steps particles in free flight, in the buffer that readers see.</summary>
    internal sealed class BallisticStepper : IFluidStepper
    {
        private readonly BallisticState state;
        private readonly FlyPass fly;

        public BallisticStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount)
        {
            fly = new FlyPass(shaders);
            state = new BallisticState(settings, particleCount);
        }

        /// <inheritdoc/>
        public FluidState State => state;

        /// <inheritdoc/>
        public void RecordLoad(CommandBuffer cmd)
        {
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
        }

        /// <inheritdoc/>
        public int StepsPerSetup(int steps, float timeStep, float speed) => 1;

        /// <inheritdoc/>
        public void PlanSteps(int steps, float timeStep, float speed, float longest)
        {
        }

        /// <inheritdoc/>
        public void RecordMotion(CommandBuffer cmd, in FluidStep step) => fly.Record(cmd, state, step);

        /// <inheritdoc/>
        public void RecordPublish(CommandBuffer cmd)
        {
        }

        public void Dispose() => state.Dispose();
    }
}
