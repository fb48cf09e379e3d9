using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals that several kernels of the Robust method share.</summary>
    internal static class RobustBindings
    {
        private static readonly int GradientFactor = Shader.PropertyToID("_GradientFactor");
        private static readonly int InverseMoment = Shader.PropertyToID("_InverseMoment");
        private static readonly int SlopeFactor = Shader.PropertyToID("_SlopeFactor");
        private static readonly int ViscosityFactor = Shader.PropertyToID("_ViscosityFactor");
        private static readonly int LeastSeparation = Shader.PropertyToID("_LeastSeparation");
        private static readonly int Spacing = Shader.PropertyToID("_Spacing");

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

        /// <summary>ConstraintMotion.hlsl of the first motion of a step: what acts on velocities.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="iterations">Its iterations.</param>
        public static void SetDrag(CommandBuffer cmd, ComputeKernel kernel, RobustState state, float timeStep, int iterations)
        {
            FluidSolverSettings settings = state.Settings;
            double slope = Slope(settings), viscosity = RobustRules.ActingViscosity(settings, timeStep) / settings.RestDensity;
            float sound = (float)Math.Min(settings.SoundSpeed, RobustRules.EffectiveSoundSpeed(settings, timeStep, iterations));
            CellBindings.SetFriction(cmd, kernel, state, (float)viscosity);
            ClosePairs.Set(cmd, kernel, settings.WithSoundSpeed(sound), slope, timeStep);
            kernel.SetFloat(cmd, SlopeFactor, (float)slope);
            kernel.SetFloat(cmd, ViscosityFactor, (float)(2.0 * viscosity / settings.RestDensity));
            kernel.SetFloat(cmd, LeastSeparation, 1e-3f * settings.SupportRadius);
            kernel.SetFloat(cmd, Spacing, settings.Spacing);
            kernel.Set(cmd, state.Buffers.Velocities);
        }

        private static double Moment(in FluidSolverSettings settings) =>
            WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);

        private static double Slope(in FluidSolverSettings settings) =>
            settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / Moment(settings);
    }
}
