using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The walls of triangles near each particle, and how far it is free of triangles at rest.</summary>
    internal sealed class GatherWallsPass : ComputePass
    {
        private static readonly int TimeStep = Id("_TimeStep");
        private static readonly int GapScale = Id("_GapScale");
        private static readonly int IsKept = Id("_IsKept");
        private static readonly int FloatsHere = Id("_FloatsHere");
        private static readonly int SteepestWall = Id("_SteepestWall");
        private static readonly int HasMirrors = Id("_HasMirrors");

        private readonly ComputeKernel kernel;

        public GatherWallsPass(FluidShaderSet shaders)
            : base(shaders, "GatherWalls")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="positions">Where the particles are in the order of the last sort.</param>
        /// <param name="isKept">Whether walls at rest that were gathered before stay until their particle has gone far.</param>
        /// <param name="isAtEnd">Whether the particles, and the walls that they feel, are where the step ends.</param>
        public void Record(CommandBuffer cmd, CellState state, FluidBuffer positions, bool isKept = false, bool isAtEnd = false)
        {
            // with time reversed
            Vector3 step = isAtEnd ? new Vector3(state.BodyStep.y, state.BodyStep.x, -state.BodyStep.z) : state.BodyStep;
            using (Sample(cmd))
            {
                CellBindings.SetFaces(cmd, kernel, state.Settings);
                MeshContact.Set(cmd, kernel, state.Settings);
                state.Bodies.Bind(cmd, kernel, step.x, step.y);
                CellBindings.SetCells(cmd, kernel, state);
                kernel.SetFloat(cmd, TimeStep, step.z);
                kernel.SetFloat(cmd, SteepestWall, state.SteepestWall);
                kernel.SetBool(cmd, HasMirrors, state.HasMirrors);
                kernel.SetFloat(cmd, FloatsHere, isAtEnd ? 1f : 0f);
                kernel.SetFloat(cmd, GapScale, state.Bodies.IsUnderWay ? 0f : 0.999f);
                kernel.SetInt(cmd, IsKept, isKept ? 1 : 0);
                kernel.SetBuffer(cmd, state.Buffers.Positions.Id, positions);
                CellBindings.SetFloating(cmd, kernel, state);
                kernel.SetOut(cmd, state.List.WallSlot);
                kernel.SetOut(cmd, state.List.WallBodies);
                kernel.SetOut(cmd, state.Walls.NearWalls);
                kernel.SetOut(cmd, state.Walls.WallGap);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
