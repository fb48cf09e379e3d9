using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What parts particles that are too near to each other, whatever the pressure (Shaders/Solver/Standard/ClosePairs.hlsl).
    /// Constants by rule, from dx, c and the step.
    /// </summary>
    internal static class ClosePairs
    {
        /// <summary>Distance from which on a pair feels nothing, r0/dx. Settled liquid stays farther apart.</summary>
        public const double Reach = 0.65;

        /// <summary>Below this distance the push falls to zero, e/dx.</summary>
        public const double Core = 0.1;

        /// <summary>K/c²: from 0.3 dx two particles at rest part with 0.008 c, within some 50 dx/c.</summary>
        public const double Push = 2.5e-5;

        /// <summary>D dx/c.</summary>
        public const double Damping = 0.5;

        // D kick: a pair on its own loses no more than all of its speed of approach in a step, so no step is too long for it.
        const double MostDamping = 0.5;

        static readonly int Constants = Shader.PropertyToID("_ClosePairs");

        /// <summary>D [1/s].</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="kick">How far the velocities go in the step [s].</param>
        public static double DampingRate(in FluidSolverSettings settings, double kick) =>
            Math.Min(Damping * settings.SoundSpeed / settings.Spacing, MostDamping / kick);

        /// <summary>Records them.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">The kernel that is dispatched next.</param>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="slopeFactor">What the kernel multiplies its sum over the neighbours with.</param>
        /// <param name="kick">How far the velocities go in the step [s].</param>
        public static void Set(
            CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, double slopeFactor, double kick)
        {
            double reach = Reach * settings.Spacing, core = Core * settings.Spacing;
            double push = Push * settings.SoundSpeed * settings.SoundSpeed;
            kernel.SetVector(cmd, Constants, new Vector4((float)(2.0 / (reach * reach)), (float)(core * core),
                (float)(push / slopeFactor), (float)(DampingRate(settings, kick) / slopeFactor)));
        }
    }
}
