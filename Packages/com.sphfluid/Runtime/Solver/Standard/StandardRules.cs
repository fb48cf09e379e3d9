using System;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Standard method by rule: those of <see cref="CellRules"/>, and
    /// dt = min(0.75 · 0.9 R/(c/M + v_max), 0.4 dx/v_max, 0.035 M R²/ν), M the lattice's moment; <see cref="TimeStepAdvice"/>.
    /// Where the last is less than half of the others, viscosity is implicit and does not count.
    /// </summary>
    internal static class StandardRules
    {
        // Wendland's C2 for density and force: the lattice's borders are 0.86 to 0.93 R M/c and 0.072 R² M/ν (von Neumann), M the lattice's moment.
        const double AcousticBorder = 0.9;
        const double ViscousLimit = 0.035;
        const double ViscousBorder = 0.072;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            FluidSolverSettings settings = CellRules.Derive(input, out double speed, out double sound, out double kinematic);
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            bool isImplicit = IsImplicit(input, Advise(dx, radius, sound, speed, kinematic, false));
            double step = Advise(dx, radius, sound, speed, kinematic, isImplicit).Step(input.TimeStepFraction);
            settings.TimeStep = input.FixedTimeStep > 0f ? input.FixedTimeStep : (float)step;
            return settings.WithOwn(new StandardSettings
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
