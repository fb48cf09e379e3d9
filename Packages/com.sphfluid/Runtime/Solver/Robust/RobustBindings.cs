using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals that several kernels of the Robust method share.</summary>
    internal static class RobustBindings
    {
        private static readonly int GradientFactor = Shader.PropertyToID("_GradientFactor");
        private static readonly int InverseMoment = Shader.PropertyToID("_InverseMoment");
        private static readonly int Spacing = Shader.PropertyToID("_Spacing");
        private static readonly int IsFirst = Shader.PropertyToID("_IsFirst");

        /// <summary>The factors of a constraint's gradients: m 210/(π R⁵)/(M ρ0) for pairs, 1/M for walls.</summary>
        public static void SetGradients(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            double slope = settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius);
            kernel.SetFloat(cmd, GradientFactor, (float)(slope / (moment * settings.RestDensity)));
            kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / moment));
        }

        /// <summary>
        /// ListedPairs.hlsl and ConstraintMotion.hlsl: the pairs that the last pass over the densities listed, and the motion by what it
        /// changed of the multipliers.
        /// </summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="isFirst">Whether it is the first motion of the step.</param>
        public static void SetMotion(CommandBuffer cmd, ComputeKernel kernel, RobustState state, float timeStep, bool isFirst)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            CellBindings.SetShell(cmd, kernel, state.Settings, timeStep);
            SetGradients(cmd, kernel, state.Settings);
            kernel.SetFloat(cmd, Spacing, state.Settings.Spacing);
            kernel.SetBool(cmd, IsFirst, isFirst);
            state.List.Set(cmd, kernel);
            kernel.Set(cmd, state.Buffers.Positions);
            kernel.Set(cmd, state.Buffers.PositionTerms);
            kernel.Set(cmd, state.Motion.Starts);
        }
    }
}
