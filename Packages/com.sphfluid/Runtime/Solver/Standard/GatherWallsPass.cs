using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The walls of triangles near each particle.</summary>
    internal sealed class GatherWallsPass : ComputePass
    {
        static readonly int ParticleCount = Id("_ParticleCount");
        static readonly int TimeStep = Id("_TimeStep");

        readonly ComputeKernel kernel;

        public GatherWallsPass(FluidShaderSet shaders)
            : base(shaders, "GatherWalls")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            using (Sample(cmd))
            {
                StandardBindings.SetFaces(cmd, kernel, state.Settings);
                MeshContact.Set(cmd, kernel, state.Settings);
                state.Bodies.Bind(cmd, kernel, state.BodyStep.x, state.BodyStep.y);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, TimeStep, state.BodyStep.z);
                kernel.Set(cmd, state.Buffers.Positions);
                kernel.SetOut(cmd, state.Walls.WallSlot);
                kernel.SetOut(cmd, state.Walls.NearWalls);
                kernel.SetOut(cmd, state.Walls.ContactArguments);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
