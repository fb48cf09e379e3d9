using System;

namespace SphFluid
{
    /// <summary>
    /// When the Standard method solves for its viscosity, (I + dt L) v = v*, instead of adding it: Shaders/Solver/Standard/Viscosity. L is
    /// the same sum over neighbours and the same friction of walls, so both have one limit for short steps; the implicit one is stable for
    /// any.
    /// </summary>
    internal static class ImplicitViscosity
    {
        /// <summary>Most iterations of a step. Where more were needed, the step is what <see cref="LargestStep"/> allows.</summary>
        public const int MostIterations = 64;

        // By how much an iteration's start, the velocities before the step, may still be seen in the solution.
        private const double Remains = 0.05;

        // The bound of the spectrum over that of a lattice at rest: compression, and walls that take more than the liquid they replace.
        private const double Reserve = 1.3;

        // Explicit steps as long as half of what else allows are cheaper than a solution.
        private const double Threshold = 0.5;

        /// <summary>Whether a viscosity is to be implicit.</summary>
        /// <param name="explicitStep">The longest step with an explicit one [s].</param>
        /// <param name="otherStep">The step that all else allows [s].</param>
        public static bool Pays(double explicitStep, double otherStep) => explicitStep < Threshold * otherStep;

        /// <summary>The longest step that <see cref="MostIterations"/> solve [s].</summary>
        /// <param name="ratio">κ = R/dx.</param>
        /// <param name="radius">R [m].</param>
        /// <param name="kinematic">ν [m²/s].</param>
        public static double LargestStep(double ratio, double radius, double kinematic)
        {
            if (!(kinematic > 0.0)) return double.PositiveInfinity;
            double sum = MostIterations / Decay();
            return (sum * sum - 1.0) / SpectralRate(ratio, radius, kinematic);
        }

        /// <summary>Iterations that a step takes.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="kick">How far the velocities go in the step [s].</param>
        public static int Iterations(in FluidSolverSettings settings, double kick)
        {
            double rate = SpectralRate(settings.SupportRadius / (double)settings.Spacing, settings.SupportRadius,
                settings.Viscosity / settings.RestDensity);
            return Math.Min(MostIterations, Math.Max(2, (int)Math.Ceiling(Decay() * Math.Sqrt(1.0 + kick * rate))));
        }

        /// <summary>1 − cos(π/2K): where T_K has its outermost zero.</summary>
        public static double ZeroShare(int iterations)
        {
            double sine = Math.Sin(Math.PI / (4.0 * iterations));
            return 2.0 * sine * sine;
        }

        // K = ½ √(b/a) ln(2/ε), with a = 0.85.
        private static double Decay() => 0.5 * Math.Log(2.0 / Remains) / Math.Sqrt(0.85);

        // Gershgorin's bound of a lattice's L: twice the sum of its pairs' rates.
        private static double SpectralRate(double ratio, double radius, double kinematic) =>
            Reserve * 2.0 * kinematic * WendlandKernel.LatticeViscosity(ratio) / (radius * radius);
    }
}
