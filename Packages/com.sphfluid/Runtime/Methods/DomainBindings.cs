using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals and keywords of what the domain does to the liquid, for the kernels of any method.</summary>
    internal static class DomainBindings
    {
        const string PeriodicKeyword = "FLUID_PERIODIC";
        const string BodyForceKeyword = "FLUID_BODY_FORCE";
        const string NoSlipKeyword = "FLUID_NO_SLIP";

        /// <summary>Shaders/Neighbours/PeriodicAxes.hlsl.</summary>
        public static void SetPeriodic(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            bool on = settings.Boundaries.Periodic != FluidAxes.None;
            kernel.SetKeyword(cmd, PeriodicKeyword, on);
            if (on)
            {
                kernel.SetVector(cmd, FluidShaderIds.PeriodLength, settings.PeriodLength);
                kernel.SetVector(cmd, FluidShaderIds.PeriodRate, settings.PeriodRate);
            }
        }

        /// <summary>Shaders/Methods/BodyForce.hlsl.</summary>
        public static void SetBodyForce(CommandBuffer cmd, ComputeKernel kernel, in FluidBodyForce force)
        {
            kernel.SetKeyword(cmd, BodyForceKeyword, force.IsOn);
            if (force.IsOn)
            {
                kernel.SetVector(cmd, FluidShaderIds.BodyForceCentre, force.Centre);
                kernel.SetVector(cmd, FluidShaderIds.BodyForceRate, force.RateSquared);
            }
        }

        /// <summary>Shaders/Methods/WallDrag.hlsl.</summary>
        public static void SetWallDrag(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, in FluidStep step)
        {
            float friction = settings.Boundaries.Friction;
            SetWallVelocities(cmd, kernel, settings.Boundaries, friction > 0f);
            if (friction > 0f)
            {
                kernel.SetFloat(cmd, FluidShaderIds.DragSpeed, friction * settings.Viscosity / (settings.RestDensity * settings.Spacing));
                kernel.SetFloat(cmd, FluidShaderIds.DragDistance, settings.Spacing);
                kernel.SetFloat(cmd, FluidShaderIds.DragStep, step.Kick);
            }
        }

        /// <summary>The walls' velocities alone, for a kernel that has a drag of its own.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="walls">The faces.</param>
        /// <param name="rub">Whether anything holds the liquid: a face or a collider.</param>
        public static void SetWallVelocities(CommandBuffer cmd, ComputeKernel kernel, in FluidBoundaries walls, bool rub)
        {
            kernel.SetKeyword(cmd, NoSlipKeyword, rub);
            if (rub)
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
}
