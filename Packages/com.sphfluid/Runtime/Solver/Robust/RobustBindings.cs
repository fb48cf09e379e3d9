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
            kernel.SetFloat(cmd, GradientFactor, (float)(Slope(settings) / settings.RestDensity));
            kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / Moment(settings)));
        }

        /// <summary>
        /// ListedPairs.hlsl and ConstraintMotion.hlsl: the pairs that the last pass over the densities listed, and the motion by what it
        /// changed of the multipliers.
        /// </summary>
        public static void SetMotion(CommandBuffer cmd, ComputeKernel kernel, RobustState state, float timeStep)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            CellBindings.SetShell(cmd, kernel, state.Settings, timeStep);
            SetGradients(cmd, kernel, state.Settings);
            state.List.Set(cmd, kernel);
            kernel.Set(cmd, state.Buffers.Positions);
            kernel.Set(cmd, state.Buffers.PositionTerms);
            kernel.Set(cmd, state.Motion.Starts);
        }

        private static double Moment(in FluidSolverSettings settings) =>
            WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);

        /// <summary>m 210/(π R⁵)/M, with which (1 − q)³ d makes a gradient [kg/m⁵].</summary>
        public static double Slope(in FluidSolverSettings settings) =>
            settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / Moment(settings);
    }
}
