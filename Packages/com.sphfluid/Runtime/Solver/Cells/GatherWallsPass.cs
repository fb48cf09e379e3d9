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
        private static readonly int WalledArguments = Id("_WalledArguments");
        private static readonly int HasMirrors = Id("_HasMirrors");

        private readonly ComputeKernel findWalled, gatherWalls;

        public GatherWallsPass(FluidShaderSet shaders)
            : base(shaders, "GatherWalls")
        {
            findWalled = Kernel("FindWalled");
            gatherWalls = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="positions">Where the particles are in the order of the last sort.</param>
        /// <param name="isKept">Whether walls at rest that were gathered before stay until their particle has gone far.</param>
        /// <param name="isAtEnd">Whether the particles, and the walls that they feel, are where the step ends.</param>
        public void Record(CommandBuffer cmd, CellState state, FluidBuffer positions, bool isKept = false, bool isAtEnd = false)
        {
            state.Walls.LackSleepers = !isKept && AwakeGroups.AreLeftOut(state);
            Record(cmd, state, positions, isKept, isAtEnd, false);
        }

        /// <summary>The same for groups of particles that all sleep: no step needs their walls, but drawing does.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers, behind a sort.</param>
        public void RecordAsleep(CommandBuffer cmd, CellState state)
        {
            state.Walls.LackSleepers = false;
            Record(cmd, state, state.Buffers.Positions, false, false, true);
        }

        private void Record(CommandBuffer cmd, CellState state, FluidBuffer positions, bool isKept, bool isAtEnd, bool areAsleep)
        {
            // with time reversed
            Vector3 step = isAtEnd ? new Vector3(state.BodyStep.y, state.BodyStep.x, -state.BodyStep.z) : state.BodyStep;
            using (Sample(cmd))
            {
                state.Walls.BeginGathering();
                Bind(cmd, findWalled, state, positions, step, isKept, isAtEnd);
                CellBindings.SetCells(cmd, findWalled, state);
                findWalled.SetOut(cmd, state.Walls.Walled);
                if (areAsleep) state.Sleep.Groups.DispatchAsleep(cmd, findWalled, state);
                else AwakeGroups.Dispatch(cmd, findWalled, state);
                Bind(cmd, gatherWalls, state, positions, step, isKept, isAtEnd);
                MeshContact.Set(cmd, gatherWalls, state.Settings);
                gatherWalls.SetFloat(cmd, TimeStep, step.z);
                gatherWalls.SetFloat(cmd, SteepestWall, state.SteepestWall);
                gatherWalls.SetBool(cmd, HasMirrors, state.HasMirrors);
                gatherWalls.SetOut(cmd, state.Walls.NearWalls);
                gatherWalls.Set(cmd, state.Walls.Walled);
                gatherWalls.DispatchIndirect(cmd, state.Walls.Walled, state.Walls.WalledArguments);
            }
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, CellState state, FluidBuffer positions, Vector3 step, bool isKept,
            bool isAtEnd)
        {
            CellBindings.SetFaces(cmd, kernel, state.Settings);
            CellBindings.SetFloating(cmd, kernel, state);
            state.Bodies.Bind(cmd, kernel, step.x, step.y);
            kernel.SetFloat(cmd, FloatsHere, isAtEnd ? 1f : 0f);
            kernel.SetFloat(cmd, GapScale, state.Bodies.IsUnderWay ? 0f : 0.999f);
            kernel.SetInt(cmd, IsKept, isKept ? 1 : 0);
            kernel.SetInt(cmd, WalledArguments, (int)state.Walls.WalledArguments);
            kernel.SetBuffer(cmd, state.Buffers.Positions.Id, positions);
            kernel.SetOut(cmd, state.List.WallSlot);
            kernel.SetOut(cmd, state.List.WallBodies);
            kernel.SetOut(cmd, state.Walls.WallGap);
        }
    }
}
