using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals that several kernels of the Robust method share.</summary>
    internal static class RobustBindings
    {
        private static readonly int GradientFactor = Shader.PropertyToID("_GradientFactor");
        private static readonly int InverseMoment = Shader.PropertyToID("_InverseMoment");

        /// <summary>The factors of a constraint's gradients: m 210/(π R⁵)/(M ρ0) for pairs, 1/M for walls.</summary>
        public static void SetGradients(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            double slope = settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius);
            kernel.SetFloat(cmd, GradientFactor, (float)(slope / (moment * settings.RestDensity)));
            kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / moment));
        }

        /// <summary>ListedPairs.hlsl: the pairs that the last pass over the densities listed.</summary>
        public static void SetPairs(CommandBuffer cmd, ComputeKernel kernel, RobustState state)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            state.List.Set(cmd, kernel);
            kernel.Set(cmd, state.Buffers.Positions);
            kernel.Set(cmd, state.Buffers.PositionTerms);
        }
    }
}
