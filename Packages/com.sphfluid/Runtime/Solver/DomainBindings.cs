using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals of what the domain does to the liquid, for the kernels of any method.</summary>
    internal static class DomainBindings
    {
        private const string PeriodicKeyword = "FLUID_PERIODIC";

        // m: where a face is not of the kind. Its square is still a float.
        private const float FarAway = 1e18f;

        // m: no distance to a wall is less.
        private const float Nowhere = -1e18f;

        private static readonly int WallsLow = Shader.PropertyToID("_WallsLow");
        private static readonly int WallsHigh = Shader.PropertyToID("_WallsHigh");
        private static readonly int OpenLow = Shader.PropertyToID("_OpenLow");
        private static readonly int OpenHigh = Shader.PropertyToID("_OpenHigh");
        private static readonly int PeriodLength = Shader.PropertyToID("_PeriodLength");
        private static readonly int PeriodRate = Shader.PropertyToID("_PeriodRate");
        private static readonly int BodyForceCentre = Shader.PropertyToID("_BodyForceCentre");
        private static readonly int BodyForceRate = Shader.PropertyToID("_BodyForceRate");
        private static readonly int DragSpeed = Shader.PropertyToID("_DragSpeed");
        private static readonly int DragDistance = Shader.PropertyToID("_DragDistance");
        private static readonly int DragStep = Shader.PropertyToID("_DragStep");
        private static readonly int WallLowX = Shader.PropertyToID("_WallLowX");
        private static readonly int WallLowY = Shader.PropertyToID("_WallLowY");
        private static readonly int WallLowZ = Shader.PropertyToID("_WallLowZ");
        private static readonly int WallHighX = Shader.PropertyToID("_WallHighX");
        private static readonly int WallHighY = Shader.PropertyToID("_WallHighY");
        private static readonly int WallHighZ = Shader.PropertyToID("_WallHighZ");

        /// <summary>
        /// Periodic axes of Shaders/Solver/DomainFaces.hlsl, for kernels with variants and for those that go by the lengths.
        /// </summary>
        public static void SetPeriodic(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            bool on = settings.Boundaries.Periodic != FluidAxes.None;
            if (kernel.HasKeyword(PeriodicKeyword)) kernel.SetKeyword(cmd, PeriodicKeyword, on);
            kernel.SetVector(cmd, PeriodLength, on ? settings.PeriodLength : Vector3.zero);
            kernel.SetVector(cmd, PeriodRate, on ? settings.PeriodRate : Vector3.zero);
        }

        /// <summary>For a variant that goes by the lengths, of a kernel that has others, after <see cref="SetPeriodic"/>.</summary>
        public static void SetPeriodicByLengths(CommandBuffer cmd, ComputeKernel kernel)
        {
            if (kernel.HasKeyword(PeriodicKeyword)) kernel.SetKeyword(cmd, PeriodicKeyword, false);
        }

        /// <summary>Shaders/Solver/BodyForce.hlsl.</summary>
        public static void SetBodyForce(CommandBuffer cmd, ComputeKernel kernel, in FluidBodyForce force)
        {
            kernel.SetVector(cmd, BodyForceCentre, force.IsOn ? force.Centre : Vector3.zero);
            kernel.SetVector(cmd, BodyForceRate, force.IsOn ? force.RateSquared : Vector3.zero);
        }

        /// <summary>Shaders/Solver/WallDrag.hlsl.</summary>
        public static void SetWallDrag(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, in FluidStep step)
        {
            float friction = settings.Boundaries.Friction;
            SetWallVelocities(cmd, kernel, settings.Boundaries);
            kernel.SetFloat(cmd, DragSpeed, friction * settings.Viscosity / (settings.RestDensity * settings.Spacing));
            kernel.SetFloat(cmd, DragDistance, friction > 0f ? settings.Spacing : Nowhere);
            kernel.SetFloat(cmd, DragStep, step.Kick);
        }

        /// <summary>The walls' velocities alone, for a kernel that has a drag of its own.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="walls">The faces.</param>
        public static void SetWallVelocities(CommandBuffer cmd, ComputeKernel kernel, in FluidBoundaries walls)
        {
            kernel.SetVector(cmd, WallLowX, walls.LowX);
            kernel.SetVector(cmd, WallLowY, walls.LowY);
            kernel.SetVector(cmd, WallLowZ, walls.LowZ);
            kernel.SetVector(cmd, WallHighX, walls.HighX);
            kernel.SetVector(cmd, WallHighY, walls.HighY);
            kernel.SetVector(cmd, WallHighZ, walls.HighZ);
        }

        /// <summary>
        /// DomainFaces.hlsl: where the faces are walls and where they are open; the walls a distance of <paramref name="inset"/> [m]
        /// further in than the faces.
        /// </summary>
        public static void SetFaces(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, float inset = 0f)
        {
            FluidBoundaries boundaries = settings.Boundaries;
            FluidFaces walls = ~(boundaries.Open | FluidBoundaries.FacesOf(boundaries.Periodic));
            Vector3 face = 0.5f * settings.DomainSize, wall = face - inset * Vector3.one;
            kernel.SetVector(cmd, WallsLow, -Where(wall, walls, FluidFaces.LowX, FluidFaces.LowY, FluidFaces.LowZ));
            kernel.SetVector(cmd, WallsHigh, Where(wall, walls, FluidFaces.HighX, FluidFaces.HighY, FluidFaces.HighZ));
            kernel.SetVector(cmd, OpenLow, -Where(face, boundaries.Open, FluidFaces.LowX, FluidFaces.LowY, FluidFaces.LowZ));
            kernel.SetVector(cmd, OpenHigh, Where(face, boundaries.Open, FluidFaces.HighX, FluidFaces.HighY, FluidFaces.HighZ));
        }

        private static Vector3 Where(Vector3 place, FluidFaces faces, FluidFaces x, FluidFaces y, FluidFaces z) => new Vector3(
            (faces & x) != 0 ? place.x : FarAway, (faces & y) != 0 ? place.y : FarAway, (faces & z) != 0 ? place.z : FarAway);
    }
}
