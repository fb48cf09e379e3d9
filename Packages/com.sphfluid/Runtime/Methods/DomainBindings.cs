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
            SetNoSlip(cmd, kernel, settings.Boundaries);
            if (settings.Boundaries.NoSlip)
            {
                kernel.SetFloat(cmd, FluidShaderIds.DragSpeed, settings.Viscosity / (settings.RestDensity * settings.Spacing));
                kernel.SetFloat(cmd, FluidShaderIds.DragDistance, settings.Spacing);
                kernel.SetFloat(cmd, FluidShaderIds.DragStep, step.Kick);
            }
        }

        /// <summary>The walls' velocities alone, for a kernel that has a drag of its own.</summary>
        public static void SetNoSlip(CommandBuffer cmd, ComputeKernel kernel, in FluidBoundaries walls)
        {
            kernel.SetKeyword(cmd, NoSlipKeyword, walls.NoSlip);
            if (walls.NoSlip)
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
