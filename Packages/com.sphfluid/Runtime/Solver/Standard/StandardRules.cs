using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Standard method by rule: those of <see cref="CellRules"/>, and
    /// dt = min(0.75 · 0.9 R/(c/M + v_max), 0.4 dx/v_max, 0.035 M R²/ν), M the lattice's moment; <see cref="TimeStepAdvice"/>.
    /// Where the last is less than half of the others, viscosity is implicit and does not count.
    /// A force may ask for a greater c and a smaller dt: <see cref="ParticleForce"/>.
    /// </summary>
    internal static class StandardRules
    {
        // Wendland's C2 for density and force: the lattice's borders are 0.86 to 0.93 R M/c and 0.072 R² M/ν (von Neumann), M the lattice's
        // moment.
        private const double AcousticBorder = 0.9;
        private const double ViscousLimit = 0.035;
        private const double ViscousBorder = 0.072;

        // Of the profile's Viscosity Ratio: one kernel for density and force needs a tenth of what the thesis's two need.
        private const double ViscosityShare = 0.1;

        // Steps of a list where forces act of their own, which move particles of the surface one by one or are made with the list.
        private const int MostStepsWithForces = 8;

        // Of a liquid that is far from cameras: below such a ratio, above such a compression it is a sponge from there too.
        private const double LeastRatio = 2.5, MostCompression = 0.16;

        // τ c/R, and the rate at which density grows over ρ0 c/R.
        private const float ImpactTime = 0.4f, ImpactRate = 0.07f;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            var own = new StandardSettings
            {
                StableOrder = true, NeighbourList = true, StepsPerSort = 16,
                ListClosing = (float)ListReuse.ClosingFor(input.Stiffness),
            };
            foreach (ParticleForce force in StandardForces.All) force.Derive(input, ref own);
            FluidSolverSettings settings = CellRules.Derive(
                input, ViscosityShare, out double speed, out double sound, out double kinematic,
                StandardForces.LeastSoundSpeed(input, own));
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double forceStep = StandardForces.LargestStep(settings.WithOwn(own));
            own.ImplicitViscosity = IsImplicit(input, Advise(dx, radius, sound, speed, kinematic, false, forceStep), forceStep);
            own.SoundSpeed = (float)Math.Sqrt((float)(sound * sound));
            double step = Advise(dx, radius, sound, speed, kinematic, own.ImplicitViscosity, forceStep).Step(input.TimeStepFraction);
            settings.TimeStep = input.FixedTimeStep > 0f ? input.FixedTimeStep : (float)step;
            return settings.WithOwn(own);
        }

        /// <summary>How many times lower the speed of sound may be, and how many times longer steps by it, no more than asked.</summary>
        public static double CoarsestFactor(in FluidRuleInput input, double asked) => Math.Max(1.0, Math.Min(asked,
            Math.Min(input.SoundSpeedRatio / LeastRatio, Math.Sqrt(MostCompression / input.MaxCompression))));

        /// <summary>Why it is not lower, the end of a sentence; null: it is as low as asked.</summary>
        public static string CoarsestReason(double asked, double reached) => asked <= 1.01 * reached ? null : FormattableString.Invariant(
            $"; a Sound Speed Ratio of {LeastRatio} and a Max Compression of {MostCompression}, the softest, allow {reached:0.##} times.");

        /// <summary>Advice for a running liquid.</summary>
        public static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed)
        {
            StandardSettings own = settings.Own<StandardSettings>();
            return Advise(settings.Spacing, settings.SupportRadius, settings.SoundSpeed, maxSpeed,
                settings.Viscosity / settings.RestDensity,
                own.ImplicitViscosity, StandardForces.LargestStep(settings));
        }

        /// <summary>
        /// Advice from bare numbers. The walls set no limit of their own; the forces are over <see cref="WendlandKernel.LatticeMoment"/>.
        /// </summary>
        public static TimeStepAdvice Advise(double spacing, double radius, double sound, double speed, double kinematic,
            bool isImplicit = false,
            double forceStep = double.PositiveInfinity)
        {
            double moment = WendlandKernel.LatticeMoment(radius / spacing);
            double viscous = isImplicit ? ImplicitViscosity.LargestStep(radius / spacing, radius, kinematic)
                : TimeStepAdvice.ViscousStep(ViscousLimit * moment, radius, kinematic);
            double border = isImplicit ? double.PositiveInfinity : TimeStepAdvice.ViscousStep(ViscousBorder * moment, radius, kinematic);
            return new TimeStepAdvice(
                AcousticBorder * radius / (sound / moment + speed), TimeStepAdvice.SpeedStep(spacing, speed), viscous, border,
                double.PositiveInfinity, sound, speed, kinematic, isImplicit, capillary: forceStep);
        }

        /// <summary>What two bodies may close while a list serves, over R.</summary>
        public static double ListClosing(in StandardSettings own) =>
            StandardForces.Act(own) ? Math.Min(own.ListClosing, ListReuse.CarefulClosing) : own.ListClosing;

        /// <summary>Steps that one sort serves, 1 or more.</summary>
        /// <param name="own">The liquid's constants.</param>
        /// <param name="after">Steps that lists serve after the first, as <see cref="ListReuse"/> has it.</param>
        public static int StepsPerSort(in StandardSettings own, double after)
        {
            int most = StandardForces.Act(own) ? Math.Min(own.StepsPerSort, MostStepsWithForces) : own.StepsPerSort;
            return 1 + (int)Math.Min(most - 1, after);
        }

        /// <summary>What StandardDensity.compute needs of the last step: τ/dt, and by how much density may grow in it without τ.</summary>
        public static Vector2 Impact(in FluidSolverSettings settings, float step)
        {
            float crossing = settings.SupportRadius / settings.SoundSpeed;
            return new Vector2(ImpactTime * crossing / step, ImpactRate * settings.RestDensity * step / crossing);
        }

        // A step that the user gives is taken as it is, so what holds it is chosen by it.
        private static bool IsImplicit(in FluidRuleInput input, in TimeStepAdvice asExplicit, double forceStep)
        {
            if (input.FixedTimeStep > 0f) return asExplicit.Viscosity < input.FixedTimeStep;
            return ImplicitViscosity.Pays(asExplicit.Viscosity,
                Math.Min(forceStep, Math.Min(input.TimeStepFraction * asExplicit.Acoustic, asExplicit.Speed)));
        }
    }
}
