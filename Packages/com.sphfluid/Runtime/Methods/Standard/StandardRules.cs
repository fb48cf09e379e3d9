using System;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Standard method by rule.
    /// <list type="bullet">
    /// <item><description>v_max = √(v0² + 2 g H): a fall from the top of the liquid to the floor.</description></item>
    /// <item><description>c = max(ratio v_max, √(g D / η)): the compression η allowed at rest, 1/ratio² in motion.</description></item>
    /// <item><description>m = ρ0 dx³ / Σ W dx³: the rest lattice has the rest density.</description></item>
    /// <item><description>ν = max(real, α c R), α = 0.002: less than a fifth of what the thesis's two kernels need.</description></item>
    /// <item><description>dt = min(0.6 R/(c + v_max), 0.4 dx/v_max, 0.035 R²/ν); the lattice is stable up to 0.86 R/c and 0.072 R²/ν.</description></item>
    /// </list>
    /// </summary>
    internal static class StandardRules
    {
        // The profile's ratios are the thesis method's; the same knob means the same share of either border.
        const double AcousticLimit = 1.0;
        const double SpeedLimit = 0.4;
        const double ViscousLimit = 0.035;
        const double ViscosityShare = 0.2;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double gravity = input.Gravity.magnitude;
            double speed = Math.Max(input.MinSpeed, Math.Sqrt((double)input.InitialSpeed * input.InitialSpeed + 2.0 * gravity * input.LiquidHeight));
            double sound = Math.Max(input.SoundSpeedRatio * speed, Math.Sqrt(gravity * input.LiquidDepth / input.MaxCompression));
            double kinematic = Math.Max(input.KinematicViscosity, ViscosityShare * input.ViscosityRatio * sound * radius);
            double step = Math.Min(input.TimeStepFraction * AcousticLimit * radius / (sound + speed), SpeedLimit * dx / speed);
            if (kinematic > 0.0) step = Math.Min(step, ViscousLimit * radius * radius / kinematic);
            return new FluidSolverSettings
            {
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass = (float)(input.RestDensity * dx * dx * dx / WendlandKernel.LatticeSum(input.SupportRatio)),
                Stiffness = (float)(sound * sound),
                Viscosity = (float)(kinematic * input.RestDensity),
                TimeStep = (float)step,
                Gravity = input.Gravity,
                AccelerationLimit = float.MaxValue,
                MaxSpeed = (float)speed,
                SelfDensity = true,
                PressureClamp = true,
                HalfKick = true,
                StableOrder = true,
            };
        }
    }
}
