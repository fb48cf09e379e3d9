using System;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Standard method by rule.
    /// <list type="bullet">
    /// <item><description>v_max = √(v0² + 2 g H): a fall from the top of the liquid to the floor.</description></item>
    /// <item><description>c = max(ratio v_max, √(g D / η)): the compression η allowed at rest, 1/ratio² in motion.</description></item>
    /// <item><description>m = ρ0 dx³ / Σ W dx³: the rest lattice has the rest density, less what rounding may add.</description></item>
    /// <item><description>ν = max(real, α c R), α = 0.001: a tenth of what the thesis's two kernels need.</description></item>
    /// <item><description>dt = min(0.6 · 0.9 R/(c/M + v_max), 0.4 dx/v_max, 0.035 M R²/ν), M the lattice's moment; <see cref="TimeStepAdvice"/>.</description></item>
    /// </list>
    /// </summary>
    internal static class StandardRules
    {
        // The profile's ratio is the thesis method's, 0.01.
        const double ViscosityShare = 0.1;

        // A lattice that moves as one reads up to 3e-6 too dense, as places are rounded; read as pressure that takes it apart.
        const double RoundingShare = 4e-6;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double gravity = input.Gravity.magnitude;
            double speed = Math.Max(input.MinSpeed, Math.Sqrt((double)input.InitialSpeed * input.InitialSpeed + 2.0 * gravity * input.LiquidHeight));
            double sound = Math.Max(input.SoundSpeedRatio * speed, Math.Sqrt(gravity * input.LiquidDepth / input.MaxCompression));
            double kinematic = Math.Max(input.KinematicViscosity, ViscosityShare * input.ViscosityRatio * sound * radius);
            double step = TimeStepAdvice.OfOneKernel(dx, radius, sound, speed, kinematic).Step(input.TimeStepFraction);
            return new FluidSolverSettings
            {
                Method = FluidMethodKind.Standard,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass = (float)((1.0 - RoundingShare) * input.RestDensity * dx * dx * dx / WendlandKernel.LatticeSum(input.SupportRatio)),
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
                NeighbourList = true,
            };
        }
    }
}
