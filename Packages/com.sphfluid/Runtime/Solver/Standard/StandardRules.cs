using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Standard method by rule: those of <see cref="CellRules"/>, and
    /// dt = min(0.75 · 0.9 R/(c/M + v_max), 0.4 dx/v_max, 0.035 M R²/ν), M the lattice's moment; <see cref="TimeStepAdvice"/>.
    /// Where the last is less than half of the others, viscosity is implicit and does not count.
    /// With surface tension c is √(p/(ρ η)) at least, p = 1.28 σ/dx at κ = 2.25, and dt 0.2 √(ρ dx³/σ) at most: <see cref="CapillaryRules"/>.
    /// </summary>
    internal static class StandardRules
    {
        // Wendland's C2 for density and force: the lattice's borders are 0.86 to 0.93 R M/c and 0.072 R² M/ν (von Neumann), M the lattice's moment.
        const double AcousticBorder = 0.9;
        const double ViscousLimit = 0.035;
        const double ViscousBorder = 0.072;

        // τ c/R, and the rate at which density grows over ρ0 c/R.
        const float ImpactTime = 0.4f, ImpactRate = 0.07f;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            FluidSolverSettings settings = CellRules.Derive(input, out double speed, out double sound, out double kinematic, LeastSound(input, out double tension));
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double capillary = CapillaryRules.LargestStep(tension, input.RestDensity, dx);
            bool isImplicit = IsImplicit(input, Advise(dx, radius, sound, speed, kinematic, false, capillary));
            double step = Advise(dx, radius, sound, speed, kinematic, isImplicit, capillary).Step(input.TimeStepFraction);
            settings.TimeStep = input.FixedTimeStep > 0f ? input.FixedTimeStep : (float)step;
            return settings.WithOwn(new StandardSettings
            {
                SoundSpeed = (float)Math.Sqrt((float)(sound * sound)),
                StableOrder = true,
                NeighbourList = true,
                StepsPerSort = ListReuse.MostSteps,
                ImplicitViscosity = isImplicit,
                SurfaceTension = (float)tension,
                ContactAngle = input.ContactAngle,
            });
        }

        /// <summary>Advice for a running liquid.</summary>
        public static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed)
        {
            StandardSettings own = settings.Own<StandardSettings>();
            return Advise(settings.Spacing, settings.SupportRadius, settings.SoundSpeed, maxSpeed, settings.Viscosity / settings.RestDensity,
                own.ImplicitViscosity, CapillaryRules.LargestStep(own.SurfaceTension, settings.RestDensity, settings.Spacing));
        }

        /// <summary>Advice from bare numbers. The walls set no limit of their own; the forces are over <see cref="WendlandKernel.LatticeMoment"/>.</summary>
        public static TimeStepAdvice Advise(double spacing, double radius, double sound, double speed, double kinematic, bool isImplicit = false,
            double capillary = double.PositiveInfinity)
        {
            double moment = WendlandKernel.LatticeMoment(radius / spacing);
            double viscous = isImplicit ? ImplicitViscosity.LargestStep(radius / spacing, radius, kinematic) : TimeStepAdvice.ViscousStep(ViscousLimit * moment, radius, kinematic);
            double border = isImplicit ? double.PositiveInfinity : TimeStepAdvice.ViscousStep(ViscousBorder * moment, radius, kinematic);
            return new TimeStepAdvice(
                AcousticBorder * radius / (sound / moment + speed), TimeStepAdvice.SpeedStep(spacing, speed), viscous, border,
                double.PositiveInfinity, sound, speed, kinematic, isImplicit, capillary: capillary);
        }

        /// <summary>What StandardDensity.compute needs of the last step: τ/dt, and by how much density may grow in it without τ.</summary>
        public static Vector2 Impact(in FluidSolverSettings settings, float step)
        {
            float crossing = settings.SupportRadius / settings.SoundSpeed;
            return new Vector2(ImpactTime * crossing / step, ImpactRate * settings.RestDensity * step / crossing);
        }

        // A step that the user gives is taken as it is, so what holds it is chosen by it.
        static bool IsImplicit(in FluidRuleInput input, in TimeStepAdvice asExplicit)
        {
            if (input.FixedTimeStep > 0f) return asExplicit.Viscosity < input.FixedTimeStep;
            return ImplicitViscosity.Pays(asExplicit.Viscosity, Math.Min(asExplicit.SurfaceTension, Math.Min(input.TimeStepFraction * asExplicit.Acoustic, asExplicit.Speed)));
        }

        // The speed of sound that holds the pull of surface tension; 0 where there is none that acts.
        static double LeastSound(in FluidRuleInput input, out double tension)
        {
            tension = CapillaryRules.Acts(input) ? input.SurfaceTension : 0.0;
            if (tension == 0.0) return 0.0;
            if (input.SupportRatio < CapillaryRules.LeastRatio)
            {
                throw new ArgumentException(FormattableString.Invariant(
                    $"The Support Ratio is {input.SupportRatio:G3}; surface tension needs {CapillaryRules.LeastRatio} or more. Raise it, or set Surface Tension to 0."));
            }
            return CapillaryRules.LeastSoundSpeed(tension, input.RestDensity, input.Spacing, input.SupportRatio, input.MaxCompression);
        }
    }
}
