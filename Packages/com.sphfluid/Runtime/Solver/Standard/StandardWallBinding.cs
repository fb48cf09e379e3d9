using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals of Shaders/Solver/Standard/{Wendland,StandardWalls}.hlsl and Shaders/Solver/DomainFaces.hlsl.</summary>
    internal static class StandardWallBinding
    {
        static readonly int InverseSupport = Shader.PropertyToID("_InverseSupport");
        static readonly int SupportRatio = Shader.PropertyToID("_SupportRatio");
        static readonly int MirrorSpacing = Shader.PropertyToID("_MirrorSpacing");
        static readonly int RestDensity = Shader.PropertyToID("_RestDensity");
        static readonly int DomainHalfSize = Shader.PropertyToID("_DomainHalfSize");

        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            kernel.SetFloat(cmd, InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, SupportRatio, settings.SupportRadius / settings.Spacing);
            kernel.SetFloat(cmd, MirrorSpacing, settings.Spacing / settings.SupportRadius);
            kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
            kernel.SetVector(cmd, DomainHalfSize, 0.5f * settings.DomainSize);
            DomainFaces.Set(cmd, kernel, settings);
        }
    }
}
