using System;

namespace SphFluid
{
    /// <summary>
    /// Constants of the forces of Shaders/Solver/Standard/Tension from surface tension and contact angle. Their form has no theory that
    /// gives its strength at a few neighbours, so two numbers are calibrated by κ on a drop of 900 particles: one that swings with Lamb's
    /// period, ω² = 8 σ/(ρ R³), and whose particles neither leave it nor freeze. They hold for any σ, ρ and dx, because nothing else has a
    /// dimension. The wall's share is calibrated on drops of 700 particles on a plate without gravity.
    /// </summary>
    internal static class CapillaryRules
    {
        // κ; p over σ/dx; G over σ/(ρ dx²).
        private static readonly double[] Ratios = { 2.0, 2.25, 2.5, 3.0, 3.5, 4.0 };
        private static readonly double[] Pulls = { 1.28, 1.28, 1.0, 0.8, 0.7, 0.6 };
        private static readonly double[] Normals = { 1.7, 0.93, 0.65, 0.3, 0.16, 0.1 };

        // Degrees; b.
        private static readonly double[] Angles = { 0.0, 12.5, 46.0, 80.0, 93.0, 116.0, 132.0, 148.0, 162.0, 180.0 };
        private static readonly double[] Shares = { 1.3, 1.2, 1.15, 1.1, 1.0, 0.9, 0.8, 0.6, 0.5, 0.4 };

        // Of √(ρ dx³/σ): waves of two spacings have ω = √(σ k³/ρ) = 5.6 √(σ/(ρ dx³)), so leapfrog ends at 0.36.
        private const double StepLimit = 0.2;

        /// <summary>Least κ for which there are constants.</summary>
        public const double LeastRatio = 2.0;

        /// <summary>Gravity of the Earth [m/s²].</summary>
        public const double EarthGravity = 9.81;

        /// <summary>Whether a surface tension is to act: where particles resolve it, or where it is asked for.</summary>
        /// <param name="input">The liquid, its gravity and its spacing.</param>
        public static bool Acts(in FluidRuleInput input) => input.SurfaceTension > 0f &&
            (input.TensionAtAnySpacing ||
                input.Spacing <= ResolvedSpacing(input.SurfaceTension, input.RestDensity, input.Gravity.magnitude));

        /// <summary>
        /// The coarsest spacing that resolves a surface tension [m]: the capillary length √(σ/(ρ g)), at which it is as strong as gravity;
        /// 2.7 mm for water. Gravity weaker than the Earth's counts as the Earth's: the length would grow without bound, and the forces
        /// would set in while gravity fades.
        /// </summary>
        /// <param name="tension">σ [N/m].</param>
        /// <param name="density">ρ [kg/m³].</param>
        /// <param name="gravity">g [m/s²].</param>
        public static double ResolvedSpacing(double tension, double density, double gravity) =>
            Math.Sqrt(tension / (density * Math.Max(gravity, EarthGravity)));

        /// <summary>The pressure p by which pairs pull [Pa].</summary>
        public static double Cohesion(double tension, double spacing, double ratio) => Between(Ratios, Pulls, ratio) * tension / spacing;

        /// <summary>G, by which normals pull each other [m/s²].</summary>
        public static double NormalPull(double tension, in FluidSolverSettings settings)
        {
            double dx = settings.Spacing;
            return Between(Ratios, Normals, settings.SupportRadius / dx) * tension / (settings.RestDensity * dx * dx);
        }

        /// <summary>b, how much of the liquid's own pull a wall has: 1 at about 90°.</summary>
        /// <param name="angle">Contact angle in the liquid [degrees].</param>
        public static double WallShare(double angle) => Between(Angles, Shares, angle);

        /// <summary>Speed of sound that holds the pull by a compression [m/s].</summary>
        public static double LeastSoundSpeed(double tension, double density, double spacing, double ratio, double compression) =>
            Math.Sqrt(Cohesion(tension, spacing, ratio) / (density * compression));

        /// <summary>Longest step [s]; infinite without tension.</summary>
        public static double LargestStep(double tension, double density, double spacing) =>
            tension > 0.0 ? StepLimit * Math.Sqrt(density * spacing * spacing * spacing / tension) : double.PositiveInfinity;

        // Straight lines between the values, which end at the first and the last.
        private static double Between(double[] at, double[] values, double x)
        {
            int i = 1;
            while (i < at.Length - 1 && x > at[i]) i++;
            double t = Math.Max(0.0, Math.Min(1.0, (x - at[i - 1]) / (at[i] - at[i - 1])));
            return values[i - 1] + t * (values[i] - values[i - 1]);
        }
    }
}
