using System;

namespace SphFluid
{
    /// <summary>
    /// Constants that methods with Wendland's kernel and one speed of sound share.
    /// <list type="bullet">
    /// <item><description>v_max = √(v0² + 2 g H + 2 a L): a fall from the top of the liquid to the floor, in a vessel that is
    /// accelerated.</description></item>
    /// <item><description>c = max(ratio v_max, √((g D + a L) / η)): the compression η allowed at rest, 1/ratio² in
    /// motion.</description></item>
    /// <item><description>m = ρ0 dx³ / Σ W dx³: the rest lattice has the rest density, less what rounding may add.</description></item>
    /// <item><description>ν = max(real, s α c R), α the profile's Viscosity Ratio, s the method's share of it.</description></item>
    /// </list>
    /// </summary>
    internal static class CellRules
    {
        // A lattice that moves as one reads up to 3e-6 too dense, as places are rounded; read as pressure that takes it apart.
        private const double RoundingShare = 4e-6;

        /// <summary>All but the method's own constants and the step.</summary>
        /// <param name="input">What the rules start from.</param>
        /// <param name="viscosityShare">What the method needs of the profile's Viscosity Ratio, which is what the thesis's two kernels
        /// need.</param>
        /// <param name="speed">The fastest expected speed v_max [m/s].</param>
        /// <param name="sound">Speed of sound c [m/s].</param>
        /// <param name="kinematic">Kinematic viscosity ν [m²/s].</param>
        /// <param name="leastSound">Speed of sound that the method needs for other reasons [m/s].</param>
        public static FluidSolverSettings Derive(
            in FluidRuleInput input, double viscosityShare, out double speed, out double sound, out double kinematic,
            double leastSound = 0.0)
        {
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double gravity = input.Gravity.magnitude, load = (double)input.LoadSpeed * input.LoadSpeed;
            speed = Math.Max(input.MinSpeed,
                Math.Sqrt((double)input.InitialSpeed * input.InitialSpeed + 2.0 * gravity * input.LiquidHeight + load));
            sound = Math.Max(leastSound,
                Math.Max(input.SoundSpeedRatio * speed, Math.Sqrt((gravity * input.LiquidDepth + 0.5 * load) / input.MaxCompression)));
            kinematic = Math.Max(input.KinematicViscosity, viscosityShare * input.ViscosityRatio * sound * radius);
            return new FluidSolverSettings
            {
                Method = input.Method,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass =
                    (float)((1.0 - RoundingShare) * input.RestDensity * dx * dx * dx / WendlandKernel.LatticeSum(input.SupportRatio)),
                Viscosity = (float)(kinematic * input.RestDensity),
                Gravity = input.Gravity,
                MaxSpeed = (float)speed,
                PressureClamp = true,
            };
        }
    }
}
