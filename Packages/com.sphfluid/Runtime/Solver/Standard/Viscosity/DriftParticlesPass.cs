using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Walls, leapfrog and the count of the cells with velocities that are solved for, the last part of a step whose viscosity is implicit.
    /// </summary>
    internal sealed class DriftParticlesPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public DriftParticlesPass(FluidShaderSet shaders)
            : base(shaders, "DriftParticles")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            using (Sample(cmd))
            {
                CellBindings.SetSearch(cmd, kernel, state);
                MotionBindings.SetWalls(cmd, kernel, state, step);
                MotionBindings.SetEnd(cmd, kernel, state, step);
                WallForces.Set(cmd, kernel, state);
                kernel.Set(cmd, state.Buffers.Velocities);
                kernel.Set(cmd, state.Viscous.Diffused);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
