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
    /// <item><description>dt = min(0.75 · 0.9 R/(c/M + v_max), 0.4 dx/v_max, 0.035 M R²/ν), M the lattice's moment; <see cref="TimeStepAdvice"/>.
    /// Where the last is less than half of the others, viscosity is implicit and does not count.</description></item>
    /// </list>
    /// </summary>
    internal static class StandardRules
    {
        // Wendland's C2 for density and force: the lattice's borders are 0.86 to 0.93 R M/c and 0.072 R² M/ν (von Neumann), M the lattice's moment.
        const double AcousticBorder = 0.9;
        const double ViscousLimit = 0.035;
        const double ViscousBorder = 0.072;

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
            bool isImplicit = IsImplicit(input, Advise(dx, radius, sound, speed, kinematic, false));
            double step = Advise(dx, radius, sound, speed, kinematic, isImplicit).Step(input.TimeStepFraction);
            if (input.FixedTimeStep > 0f) step = input.FixedTimeStep;
            return new FluidSolverSettings
            {
                Method = FluidMethodKind.Standard,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass = (float)((1.0 - RoundingShare) * input.RestDensity * dx * dx * dx / WendlandKernel.LatticeSum(input.SupportRatio)),
                Viscosity = (float)(kinematic * input.RestDensity),
                TimeStep = (float)step,
                Gravity = input.Gravity,
                MaxSpeed = (float)speed,
                PressureClamp = true,
            }.WithOwn(new StandardSettings
            {
                SoundSpeed = (float)Math.Sqrt((float)(sound * sound)),
                StableOrder = true,
                NeighbourList = true,
                StepsPerSort = ListReuse.MostSteps,
                ImplicitViscosity = isImplicit,
            });
        }

        /// <summary>Advice for a running liquid.</summary>
        public static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) =>
            Advise(settings.Spacing, settings.SupportRadius, settings.SoundSpeed, maxSpeed, settings.Viscosity / settings.RestDensity,
                settings.Own<StandardSettings>().ImplicitViscosity);

        /// <summary>Advice from bare numbers. The walls set no limit of their own; the forces are over <see cref="WendlandKernel.LatticeMoment"/>.</summary>
        public static TimeStepAdvice Advise(double spacing, double radius, double sound, double speed, double kinematic, bool isImplicit = false)
        {
            double moment = WendlandKernel.LatticeMoment(radius / spacing);
            double viscous = isImplicit ? ImplicitViscosity.LargestStep(radius / spacing, radius, kinematic) : TimeStepAdvice.ViscousStep(ViscousLimit * moment, radius, kinematic);
            double border = isImplicit ? double.PositiveInfinity : TimeStepAdvice.ViscousStep(ViscousBorder * moment, radius, kinematic);
            return new TimeStepAdvice(
                AcousticBorder * radius / (sound / moment + speed), TimeStepAdvice.SpeedStep(spacing, speed), viscous, border,
                double.PositiveInfinity, sound, speed, kinematic, isImplicit);
        }

        // A step that the user gives is taken as it is, so what holds it is chosen by it.
        static bool IsImplicit(in FluidRuleInput input, in TimeStepAdvice asExplicit)
        {
            if (input.FixedTimeStep > 0f) return asExplicit.Viscosity < input.FixedTimeStep;
            return ImplicitViscosity.Pays(asExplicit.Viscosity, Math.Min(input.TimeStepFraction * asExplicit.Acoustic, asExplicit.Speed));
        }
    }
}
