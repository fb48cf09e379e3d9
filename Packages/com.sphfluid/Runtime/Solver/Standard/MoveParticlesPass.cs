using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Forces, leapfrog, walls and the count of the cells, in one dispatch.</summary>
    internal sealed class MoveParticlesPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public MoveParticlesPass(FluidShaderSet shaders)
            : base(shaders, "MoveParticles")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            using (Sample(cmd))
            {
                MotionBindings.SetForces(cmd, kernel, state, step);
                StandardForces.SetMotion(cmd, kernel, state, step);
                MotionBindings.SetWalls(cmd, kernel, state, step);
                MotionBindings.SetEnd(cmd, kernel, state, step);
                WallForces.Set(cmd, kernel, state);
                AwakeGroups.Dispatch(cmd, kernel, state);
            }
        }
    }
}
