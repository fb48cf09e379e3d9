using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals of what the domain does to the liquid, for the kernels of any method.</summary>
    internal static class DomainBindings
    {
        const string PeriodicKeyword = "FLUID_PERIODIC";

        // m: no distance to a wall is less.
        const float Nowhere = -1e18f;

        /// <summary>Shaders/Solver/PeriodicAxes.hlsl, for kernels with variants and for those that go by the lengths.</summary>
        public static void SetPeriodic(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            bool on = settings.Boundaries.Periodic != FluidAxes.None;
            if (kernel.HasKeyword(PeriodicKeyword))
                kernel.SetKeyword(cmd, PeriodicKeyword, on);
            kernel.SetVector(cmd, FluidShaderIds.PeriodLength, on ? settings.PeriodLength : Vector3.zero);
            kernel.SetVector(cmd, FluidShaderIds.PeriodRate, on ? settings.PeriodRate : Vector3.zero);
        }

        /// <summary>Shaders/Solver/BodyForce.hlsl.</summary>
        public static void SetBodyForce(CommandBuffer cmd, ComputeKernel kernel, in FluidBodyForce force)
        {
            kernel.SetVector(cmd, FluidShaderIds.BodyForceCentre, force.IsOn ? force.Centre : Vector3.zero);
            kernel.SetVector(cmd, FluidShaderIds.BodyForceRate, force.IsOn ? force.RateSquared : Vector3.zero);
        }

        /// <summary>Shaders/Solver/WallDrag.hlsl.</summary>
        public static void SetWallDrag(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, in FluidStep step)
        {
            float friction = settings.Boundaries.Friction;
            SetWallVelocities(cmd, kernel, settings.Boundaries);
            kernel.SetFloat(cmd, FluidShaderIds.DragSpeed, friction * settings.Viscosity / (settings.RestDensity * settings.Spacing));
            kernel.SetFloat(cmd, FluidShaderIds.DragDistance, friction > 0f ? settings.Spacing : Nowhere);
            kernel.SetFloat(cmd, FluidShaderIds.DragStep, step.Kick);
        }

        /// <summary>The walls' velocities alone, for a kernel that has a drag of its own.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="walls">The faces.</param>
        public static void SetWallVelocities(CommandBuffer cmd, ComputeKernel kernel, in FluidBoundaries walls)
        {
            kernel.SetVector(cmd, FluidShaderIds.WallLowX, walls.LowX);
            kernel.SetVector(cmd, FluidShaderIds.WallLowY, walls.LowY);
            kernel.SetVector(cmd, FluidShaderIds.WallLowZ, walls.LowZ);
            kernel.SetVector(cmd, FluidShaderIds.WallHighX, walls.HighX);
            kernel.SetVector(cmd, FluidShaderIds.WallHighY, walls.HighY);
            kernel.SetVector(cmd, FluidShaderIds.WallHighZ, walls.HighZ);
        }
    }
}
