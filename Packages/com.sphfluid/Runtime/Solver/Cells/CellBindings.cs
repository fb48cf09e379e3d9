using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Records the globals that several kernels share, by the files of Shaders/Solver/Cells that declare them.</summary>
    internal static class CellBindings
    {
        private const string MeshWalls = FluidState.MeshWalls, FloatingBodies = "FLUID_FLOATING_BODIES", Carries = "FLUID_CARRIES",
            CarriesBesides = "FLUID_CARRIES_BESIDES";

        /// <summary>What a method takes along in the sort, to read and to write.</summary>
        public static readonly int Carried = Shader.PropertyToID("_Carried"), CarriedOut = Shader.PropertyToID("_CarriedOut");

        /// <summary>WallMotion.hlsl: how far the velocities go in a step.</summary>
        public static readonly int KickStep = Shader.PropertyToID("_KickStep");

        // No particle comes nearer to a wall by its own speed, over dx; a settled liquid stays farther.
        private const float Shell = 0.25f;

        private static readonly int FaceDistance = Shader.PropertyToID("_FaceDistance");
        private static readonly int ShellDistance = Shader.PropertyToID("_ShellDistance");
        private static readonly int TimeStep = Shader.PropertyToID("_TimeStep");
        private static readonly int WallViscosity = Shader.PropertyToID("_WallViscosity");
        private static readonly int NoSlipViscosity = Shader.PropertyToID("_NoSlipViscosity");
        private static readonly int CellOrigin = Shader.PropertyToID("_CellOrigin");
        private static readonly int CellsPerMetre = Shader.PropertyToID("_CellsPerMetre");
        private static readonly int CellCounts = Shader.PropertyToID("_CellCounts");
        private static readonly int KeepsOrder = Shader.PropertyToID("_KeepsOrder");
        private static readonly int Drains = Shader.PropertyToID("_Drains");
        private static readonly int InverseSupport = Shader.PropertyToID("_InverseSupport");
        private static readonly int SupportRatio = Shader.PropertyToID("_SupportRatio");
        private static readonly int MirrorSpacing = Shader.PropertyToID("_MirrorSpacing");
        private static readonly int RestDensity = Shader.PropertyToID("_RestDensity");
        private static readonly int SuctionFloor = Shader.PropertyToID("_SuctionFloor");

        // Copied when recorded, so one array serves; command buffers are recorded on the main thread.
        [OutlivesPlay("it is filled anew for each use")] private static readonly int[] Counts = new int[4];

        /// <summary>CellRows.hlsl: the cells.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="cells">The cells.</param>
        /// <param name="sparse">How they are stored where only those with particles are.</param>
        public static void SetCells(CommandBuffer cmd, ComputeKernel kernel, in CellRows cells, SparseCells sparse = default)
        {
            Counts[3] = sparse.AreUsed ? SparseCells.LiveCount : cells.CellCount;
            Counts[0] = cells.Counts.x;
            Counts[1] = cells.Counts.y;
            Counts[2] = cells.Counts.z;
            Vector3 side = cells.CellSize;
            kernel.SetVector(cmd, CellOrigin, cells.Origin);
            kernel.SetVector(cmd, CellsPerMetre, new Vector3(1f / side.x, 1f / side.y, 1f / side.z));
            kernel.SetInts(cmd, CellCounts, Counts);
        }

        /// <summary>CellRows.hlsl: the cells and the first particle of each.</summary>
        public static void SetCells(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            SetCells(cmd, kernel, state.Cells, state.Sparse);
            kernel.Set(cmd, state.Buffers.CellTable);
        }

        /// <summary>CellSums.hlsl: what is counted in the cells, and each particle's place.</summary>
        public static void SetCounts(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetOut(cmd, state.Buffers.CellCount);
            kernel.SetOut(cmd, state.Buffers.Rank);
        }

        /// <summary>CellRows.hlsl and DomainFaces.hlsl: the search for neighbours.</summary>
        public static void SetSearch(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            SetCells(cmd, kernel, state);
            DomainBindings.SetPeriodic(cmd, kernel, state.Settings);
        }

        /// <summary>CellCounting.hlsl: where a step leaves the particles, and their count if the next one sorts.</summary>
        public static void SetCounting(CommandBuffer cmd, ComputeKernel kernel, CellState state, in FluidStep step)
        {
            kernel.SetBool(cmd, KeepsOrder, step.KeepsOrder);
            kernel.SetBool(cmd, Drains, state.IsDrained);
            kernel.SetOut(cmd, state.Buffers.NewPositions);
            SetCounts(cmd, kernel, state);
        }

        /// <summary>Wendland.hlsl and FaceWalls.hlsl: the kernel, and what the faces of the domain add to its sums.</summary>
        public static void SetFaces(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            kernel.SetFloat(cmd, InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, SupportRatio, settings.SupportRadius / settings.Spacing);
            kernel.SetFloat(cmd, MirrorSpacing, settings.Spacing / settings.SupportRadius);
            kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
            DomainBindings.SetFaces(cmd, kernel, settings);
        }

        /// <summary>Those, and MeshWalls.hlsl: what triangles near a particle add.</summary>
        public static void SetWalls(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            SetFaces(cmd, kernel, state.Settings);
            bool floats = SetImpulses(cmd, kernel, state);
            kernel.SetKeyword(cmd, MeshWalls, state.HasBodies && !floats);
            if (!state.HasBodies) return;
            kernel.Set(cmd, state.List.WallSlot);
            kernel.Set(cmd, state.List.WallBodies);
            kernel.Set(cmd, state.Walls.NearWalls);
        }

        /// <summary>Kernels that turn density into pressure: the least of it.</summary>
        public static void SetSuction(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings) =>
            kernel.SetFloat(cmd, SuctionFloor, settings.PressureClamp ? 0f : -settings.RestDensity);

        /// <summary>WallMotion.hlsl: how near to a wall a particle's own speed brings it in a step.</summary>
        public static void SetShell(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, float timeStep)
        {
            kernel.SetFloat(cmd, FaceDistance, ContactDistances.Rest(settings));
            kernel.SetFloat(cmd, ShellDistance, Shell * settings.Spacing);
            kernel.SetFloat(cmd, TimeStep, timeStep);
        }

        /// <summary>WallFriction.hlsl and WallMotion.hlsl: what walls hold.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="viscosity">Kinematic viscosity [m²/s].</param>
        public static void SetFriction(CommandBuffer cmd, ComputeKernel kernel, CellState state, float viscosity)
        {
            float friction = state.Settings.Boundaries.Friction;
            bool isHeld = friction > 0f || state.HasBodies && state.Bodies.HoldLiquid;
            DomainBindings.SetWallVelocities(cmd, kernel, state.Settings.Boundaries);
            kernel.SetFloat(cmd, WallViscosity, friction * viscosity);
            kernel.SetFloat(cmd, NoSlipViscosity, isHeld ? viscosity : 0f);
        }

        /// <summary>BodyImpulses.hlsl, for kernels that have it: what particles give to bodies that they move.</summary>
        /// <returns>Whether the kernel gives them anything.</returns>
        public static bool SetImpulses(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            if (!kernel.HasKeyword(FloatingBodies) || !SetFloating(cmd, kernel, state)) return false;
            state.Bodies.Floating.SetImpulses(cmd, kernel);
            return true;
        }

        /// <summary>The keyword of methods that take something along in the sort.</summary>
        /// <returns>Whether this one does.</returns>
        public static bool SetCarries(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            bool besides = SetCarriesBesides(cmd, kernel, state);
            kernel.SetKeyword(cmd, Carries, state.Carried != null && !besides);
            return state.Carried != null;
        }

        /// <summary>The keyword of methods that take something along besides what the new positions have.</summary>
        /// <returns>Whether this one does, and the kernel has to know.</returns>
        public static bool SetCarriesBesides(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            if (!kernel.HasKeyword(CarriesBesides)) return false;
            bool besides = state.Carried != null && state.CarriesBesides;
            kernel.SetKeyword(cmd, CarriesBesides, besides);
            return besides;
        }

        /// <summary>The keyword of bodies that the liquid moves.</summary>
        /// <returns>Whether there are any.</returns>
        public static bool SetFloating(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetKeyword(cmd, FloatingBodies, state.HasFloatingBodies);
            return state.HasFloatingBodies;
        }
    }
}
