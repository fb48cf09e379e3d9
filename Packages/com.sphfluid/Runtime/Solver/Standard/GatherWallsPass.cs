using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The walls of triangles near each particle (Shaders/Solver/Standard/GatherWalls.compute): one dispatch.</summary>
    internal sealed class GatherWallsPass
    {
        const string Keyword = "FLUID_MESH_WALLS";

        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("GatherWalls");

        readonly ComputeKernel gather;

        public GatherWallsPass(FluidShaderSet shaders)
        {
            gather = shaders.Kernel("GatherWalls", "GatherWalls");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            MeshWallBuffers walls = state.Standard.Walls;
            cmd.BeginSample(Marker);
            StandardWallBinding.Set(cmd, gather, state.Settings);
            MeshContact.Set(cmd, gather, state.Settings);
            state.Bodies.Bind(cmd, gather, state.BodyStep.x, state.BodyStep.y);
            gather.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            gather.SetFloat(cmd, FluidShaderIds.TimeStep, state.BodyStep.z);
            gather.SetBuffer(cmd, StandardShaderIds.Positions, state.Standard.Positions);
            gather.SetBuffer(cmd, StandardShaderIds.WallSlotOut, walls.WallSlot);
            gather.SetBuffer(cmd, StandardShaderIds.NearWallsOut, walls.NearWalls);
            gather.SetBuffer(cmd, StandardShaderIds.ContactArguments, walls.ContactArguments);
            gather.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }

        /// <summary>Records what a kernel needs that includes Shaders/Solver/Standard/MeshWalls.hlsl.</summary>
        public static void SetWalls(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            kernel.SetKeyword(cmd, Keyword, state.HasBodies);
            if (!state.HasBodies) return;
            kernel.SetBuffer(cmd, StandardShaderIds.WallSlot, state.Standard.Walls.WallSlot);
            kernel.SetBuffer(cmd, StandardShaderIds.NearWalls, state.Standard.Walls.NearWalls);
        }
    }
}
