using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Steps particles in free flight, in the buffer that readers see.</summary>
    internal sealed class BallisticStepper : IFluidStepper
    {
        readonly BallisticState state;
        readonly FlyPass fly;

        public BallisticStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount)
        {
            fly = new FlyPass(shaders);
            state = new BallisticState(settings, particleCount);
        }

        public FluidState State => state;

        public void RecordLoad(CommandBuffer cmd)
        {
        }

        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
        }

        public void RecordNeighbourSetupWithout(CommandBuffer cmd, string pass) =>
            throw new ArgumentException($"The ballistic method has no pass '{pass}' to leave out.", nameof(pass));

        public void RecordMotion(CommandBuffer cmd, in FluidStep step) => fly.Record(cmd, state, step);

        public void RecordPublish(CommandBuffer cmd)
        {
        }

        public void Dispose() => state.Dispose();
    }
}
