using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What parts particles that are too near to each other, whatever the pressure (Shaders/Solver/Cells/ClosePairs.hlsl).
    /// Constants by rule, from dx, c and the step.
    /// </summary>
    internal static class ClosePairs
    {
        /// <summary>Distance from which on a pair feels nothing, r0/dx. Settled liquid stays farther apart.</summary>
        public const double Reach = 0.6;

        /// <summary>K dx²/c²: two particles at rest 0.3 dx apart part with 0.015 c, those 0.5 dx apart with 0.008 c.</summary>
        public const double Push = 5e-4;

        /// <summary>D dx³/c.</summary>
        public const double Damping = 1.7;

        // D dx² kick: a pair on its own loses its speed of approach at 0.52 dx within a step, and no more at any distance, as w r² is
        // largest there and 0.27 dx². So no step is too long for it.
        private const double MostDamping = 1.85;

        private static readonly int Constants = Shader.PropertyToID("_ClosePairs");

        /// <summary>D [1/(m² s)].</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="kick">How far the velocities go in the step [s].</param>
        public static double DampingRate(in FluidSolverSettings settings, double kick)
        {
            double dx = settings.Spacing;
            return Math.Min(Damping * settings.SoundSpeed / dx, MostDamping / kick) / (dx * dx);
        }

        /// <summary>Records them.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">The kernel that is dispatched next.</param>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="slopeFactor">What the kernel multiplies its sum over the neighbours with.</param>
        /// <param name="kick">How far the velocities go in the step [s].</param>
        public static void Set(
            CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, double slopeFactor, double kick)
        {
            double reach = Reach * settings.Spacing, rate = settings.SoundSpeed / settings.Spacing;
            kernel.SetVector(cmd, Constants, new Vector4((float)(4.0 / (reach * reach)),
                (float)(Push * rate * rate / slopeFactor), (float)(DampingRate(settings, kick) / slopeFactor)));
        }
    }
}
