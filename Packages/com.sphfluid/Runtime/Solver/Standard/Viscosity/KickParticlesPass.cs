using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Velocities by all forces but viscosity, the first part of a step whose viscosity is implicit.</summary>
    internal sealed class KickParticlesPass : ComputePass
    {
        private static readonly int SpectrumSlot = Id("_SpectrumSlot");

        private readonly ComputeKernel kernel;

        public KickParticlesPass(FluidShaderSet shaders)
            : base(shaders, "KickParticles")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            state.Viscous.NextSlot();
            using (Sample(cmd))
            {
                MotionBindings.SetForces(cmd, kernel, state, step);
                MotionBindings.SetWalls(cmd, kernel, state, step);
                kernel.SetInt(cmd, SpectrumSlot, state.Viscous.Slot);
                kernel.SetOut(cmd, state.Viscous.Spectrum);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
