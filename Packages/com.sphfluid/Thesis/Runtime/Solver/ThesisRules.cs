using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Constants of the thesis method by rule, so that none is found by trying. thesis.md of com.sphfluid.validation holds the sources.
    /// <list type="bullet">
    /// <item><description>v_max = √(v0² + 2 g H): a fall from the top of the liquid to the floor.</description></item>
    /// <item><description>c_eff = max(5 v_max, √(g D / 0.04)): compression of 4 % or less, moving and at rest.</description></item>
    /// <item><description>k = 2 c_eff²: equation (13) has ½ (p_i + p_j), half of the pressure gradient.</description></item>
    /// <item><description>m = ρ0 dx³ / Σ W dx³: the rest lattice has the rest density.</description></item>
    /// <item><description>ν = max(real, α c_eff R): poly6 against spiky feeds energy in, which this takes out.</description></item>
    /// <item><description>dt = 0.6 · 1.35 R/√k, and no more than speed, 0.4 dx/v_max, viscosity, 0.06 R²/ν, and walls allow:
    /// <see cref="TimeStepAdvice"/>.</description></item>
    /// <item><description>k_w = (v_max/d)², c_w = 2 √k_w, d = dx/2: a wall stops v_max in d without rebound.</description></item>
    /// </list>
    /// </summary>
    public static class ThesisRules
    {
        /// <summary>dt √k/R at the border of stability: Müller's force on a cubic lattice by leapfrog, for κ = 2 to 4; k = 2 c².</summary>
        public const double AcousticBorder = 1.35;

        /// <summary>ν dt/R² at the border of stability: Müller's viscosity on a cubic lattice, for κ = 1.7 and more.</summary>
        public const double ViscousBorder = 0.115;

        /// <summary>ν dt/R² that is advised, about half of the border.</summary>
        public const double ViscousLimit = 0.06;

        // Penalty wall: k_w dt² < 4 − 2 c_w dt, kept with a tenth to spare.
        private const double WallMargin = 0.9;

        // The emergency limit moves a particle by one spacing in one step from rest.
        private const double AccelerationReach = 1.0;

        internal static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            double dx = input.Spacing;
            double radius = input.SupportRatio * dx;
            double gravity = input.Gravity.magnitude;
            double speed = Math.Max(input.MinSpeed,
                Math.Sqrt((double)input.InitialSpeed * input.InitialSpeed + 2.0 * gravity * input.LiquidHeight));
            double sound = Math.Max(input.SoundSpeedRatio * speed, Math.Sqrt(gravity * input.LiquidDepth / input.MaxCompression));
            double stiffness = 2.0 * sound * sound;
            double kinematic = Math.Max(input.KinematicViscosity, input.ViscosityRatio * sound * radius);

            double wallDistance = input.WallDistanceRatio * dx;
            double wallRate = Math.Sqrt(input.WallStiffnessRatio) * speed / wallDistance;
            double wallDamping = 2.0 * input.WallDampingRatio * wallRate;

            // The fraction leaves a margin for the liquid's speed, a fifth of the sound's: it is of the limit at rest.
            TimeStepAdvice atRest = Advise(dx, radius, sound, 0.0, kinematic, wallRate * wallRate, wallDamping);
            TimeStepAdvice atSpeed = Advise(dx, radius, sound, speed, kinematic, wallRate * wallRate, wallDamping);
            double step = Math.Min(atRest.Step(input.TimeStepFraction), atSpeed.Speed);
            if (input.FixedTimeStep > 0f) step = input.FixedTimeStep;
            return new FluidSolverSettings
            {
                Method = input.Method,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass = (float)(input.RestDensity * dx * dx * dx / MullerKernels.LatticeSum(input.SupportRatio)),
                Viscosity = (float)(kinematic * input.RestDensity),
                TimeStep = (float)step,
                Gravity = input.Gravity,
                MaxSpeed = (float)speed,
                PressureClamp = true,
                OctantSearch = true,
            }.WithOwn(new ThesisSettings
            {
                Stiffness = (float)stiffness,
                AccelerationLimit = EmergencyLimit(dx, (float)step),
                WallStiffness = (float)(wallRate * wallRate),
                WallDamping = (float)wallDamping,
                WallDistance = (float)wallDistance,
                SelfDensity = true,
                PressureHalf = true,
                AccelerationLimitEnabled = true,
                HalfKick = true,
            }).With(input.Switches);
        }

        /// <summary>
        /// Settings with the thesis's text as switched. The stiffness follows the ½ of equation (13), k = 2 c² or c²,
        /// so that the effective speed of sound stays; time step and viscosity stay too.
        /// </summary>
        /// <param name="settings">Constants for the thesis method.</param>
        /// <param name="switches">Corrected, printed, or any mixture.</param>
        /// <returns>The changed copy.</returns>
        public static FluidSolverSettings With(this in FluidSolverSettings settings, in ThesisSwitches switches)
        {
            FluidSolverSettings changed = settings;
            changed.PressureClamp = switches.PressureClamp;
            changed.OctantSearch = switches.OctantSearch;
            ThesisSettings own = settings.Own<ThesisSettings>();
            if (own.PressureHalf != switches.PressureHalf) own.Stiffness *= switches.PressureHalf ? 2f : 0.5f;
            own.SelfDensity = switches.SelfDensity;
            own.PressureHalf = switches.PressureHalf;
            own.ForceTimesMass = switches.ForceTimesMass;
            own.HalfKick = switches.HalfKick;
            own.FusedSort = switches.FusedSort;
            own.AccelerationLimitEnabled = switches.AccelerationLimit != ThesisAccelerationLimit.Off;
            own.AccelerationLimitFixed = switches.AccelerationLimit == ThesisAccelerationLimit.AsPrinted;
            own.AccelerationLimit = own.AccelerationLimitFixed ? settings.MaxSpeed : EmergencyLimit(settings.Spacing, settings.TimeStep);
            return changed.WithOwn(own);
        }

        /// <summary>Advice for a running liquid.</summary>
        internal static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed)
        {
            // 6.3.3 as printed multiplies the force density by m where the equation divides by ρ: m ρ times the acceleration.
            ThesisSettings own = settings.Own<ThesisSettings>();
            double factor = own.ForceTimesMass ? (double)settings.ParticleMass * settings.RestDensity : 1.0;
            return Advise(settings.Spacing, settings.SupportRadius, settings.SoundSpeed * Math.Sqrt(factor), maxSpeed,
                factor * settings.Viscosity / settings.RestDensity, own.WallStiffness, own.WallDamping);
        }

        // Advice from bare numbers. With c and v: the waves that two parts of the liquid send each other run at c on top of their own
        // speed.
        private static TimeStepAdvice Advise(double spacing, double radius, double sound, double speed, double kinematic,
            double wallStiffness, double wallDamping) =>
                new TimeStepAdvice(
                    AcousticBorder * radius / (Math.Sqrt(2.0 * sound * sound) * (1.0 + speed / sound)),
                    TimeStepAdvice.SpeedStep(spacing, speed),
                    TimeStepAdvice.ViscousStep(ViscousLimit, radius, kinematic),
                    TimeStepAdvice.ViscousStep(ViscousBorder, radius, kinematic),
                    WallStep(wallStiffness, wallDamping), sound, speed, kinematic);

        // Largest dt with k dt² = margin (4 − 2 c dt).
        private static double WallStep(double stiffness, double damping)
        {
            if (stiffness <= 0.0) return double.PositiveInfinity;
            double half = WallMargin * damping;
            return (Math.Sqrt(half * half + 4.0 * WallMargin * stiffness) - half) / stiffness;
        }

        /// <summary>Largest acceleration of the fluid itself that is no accident: one spacing in a step from rest.</summary>
        /// <param name="spacing">Particle spacing [m].</param>
        /// <param name="timeStep">Time step [s].</param>
        /// <returns>The limit [m/s²], see <see cref="ThesisSettings.AccelerationLimit"/>.</returns>
        public static float EmergencyLimit(double spacing, double timeStep) => (float)(AccelerationReach * spacing / (timeStep * timeStep));
    }
}
