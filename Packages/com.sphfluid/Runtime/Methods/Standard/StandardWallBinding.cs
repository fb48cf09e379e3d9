using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals of Shaders/Methods/Standard/{Wendland,StandardWalls}.hlsl.</summary>
    internal static class StandardWallBinding
    {
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            FluidAxes periodic = settings.Boundaries.Periodic;
            kernel.SetFloat(cmd, StandardShaderIds.InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, StandardShaderIds.SupportRatio, settings.SupportRadius / settings.Spacing);
            kernel.SetFloat(cmd, StandardShaderIds.MirrorSpacing, settings.Spacing / settings.SupportRadius);
            kernel.SetFloat(cmd, FluidShaderIds.RestDensity, settings.RestDensity);
            kernel.SetVector(cmd, FluidShaderIds.DomainHalfSize, 0.5f * settings.DomainSize);
            kernel.SetVector(cmd, StandardShaderIds.WallAxes, new Vector3((periodic & FluidAxes.X) == 0 ? 1f : 0f,
                (periodic & FluidAxes.Y) == 0 ? 1f : 0f, (periodic & FluidAxes.Z) == 0 ? 1f : 0f));
        }
    }
}
