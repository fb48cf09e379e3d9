using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals of Shaders/Solver/Standard/{Wendland,StandardWalls,DomainFaces}.hlsl.</summary>
    internal static class StandardWallBinding
    {
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            kernel.SetFloat(cmd, StandardShaderIds.InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, StandardShaderIds.SupportRatio, settings.SupportRadius / settings.Spacing);
            kernel.SetFloat(cmd, StandardShaderIds.MirrorSpacing, settings.Spacing / settings.SupportRadius);
            kernel.SetFloat(cmd, FluidShaderIds.RestDensity, settings.RestDensity);
            kernel.SetVector(cmd, FluidShaderIds.DomainHalfSize, 0.5f * settings.DomainSize);
            DomainFaces.Set(cmd, kernel, settings);
        }
    }
}
