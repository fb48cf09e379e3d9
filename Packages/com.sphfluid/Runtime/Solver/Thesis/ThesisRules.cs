using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Constants of the thesis method by rule, so that none is found by trying. Documentation~/thesis.md holds the sources.
    /// <list type="bullet">
    /// <item><description>v_max = √(v0² + 2 g H): a fall from the top of the liquid to the floor.</description></item>
    /// <item><description>c_eff = max(5 v_max, √(g D / 0.04)): compression of 4 % or less, moving and at rest.</description></item>
    /// <item><description>k = 2 c_eff²: equation (13) has ½ (p_i + p_j), half of the pressure gradient.</description></item>
    /// <item><description>m = ρ0 dx³ / Σ W dx³: the rest lattice has the rest density.</description></item>
    /// <item><description>ν = max(real, α c_eff R): poly6 against spiky feeds energy in, which this takes out.</description></item>
    /// <item><description>dt = 0.6 · 1.35 R/√k, and no more than speed, 0.4 dx/v_max, viscosity, 0.06 R²/ν, and walls allow: <see cref="TimeStepAdvice"/>.</description></item>
    /// <item><description>k_w = (v_max/d)², c_w = 2 √k_w, d = dx/2: a wall stops v_max in d without rebound.</description></item>
    /// </list>
    /// </summary>
    internal static class ThesisRules
    {
        // The emergency limit moves a particle by one spacing in one step from rest.
        const double AccelerationReach = 1.0;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            Check(input);
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

            // The fraction has room for the liquid's speed, a fifth of the sound's: it is of the limit at rest.
            TimeStepAdvice atRest = TimeStepAdvice.Of(dx, radius, sound, 0.0, kinematic, wallRate * wallRate, wallDamping);
            TimeStepAdvice atSpeed = TimeStepAdvice.Of(dx, radius, sound, speed, kinematic, wallRate * wallRate, wallDamping);
            double step = Math.Min(atRest.Step(input.TimeStepFraction), atSpeed.Speed);
            return new FluidSolverSettings
            {
                Method = input.Method,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = (float)radius,
                RestDensity = input.RestDensity,
                ParticleMass = (float)(input.RestDensity * dx * dx * dx / ThesisKernels.LatticeSum(input.SupportRatio)),
                Stiffness = (float)stiffness,
                Viscosity = (float)(kinematic * input.RestDensity),
                TimeStep = (float)step,
                Gravity = input.Gravity,
                AccelerationLimit = EmergencyLimit(dx, (float)step),
                WallStiffness = (float)(wallRate * wallRate),
                WallDamping = (float)wallDamping,
                WallDistance = (float)wallDistance,
                MaxSpeed = (float)speed,
                SelfDensity = true,
                PressureHalf = true,
                PressureClamp = true,
                AccelerationLimitEnabled = true,
                OctantSearch = true,
                HalfKick = true,
            };
        }

        /// <summary>Largest acceleration of the fluid itself that is no accident [m/s²].</summary>
        public static float EmergencyLimit(double spacing, double timeStep) => (float)(AccelerationReach * spacing / (timeStep * timeStep));

        static void Check(in FluidRuleInput input)
        {
            FluidSolverSettings.RequirePositive(input.Spacing, nameof(input.Spacing));
            FluidSolverSettings.RequirePositive(input.SupportRatio, nameof(input.SupportRatio));
            FluidSolverSettings.RequirePositive(input.RestDensity, nameof(input.RestDensity));
            FluidSolverSettings.RequirePositive(input.SoundSpeedRatio, nameof(input.SoundSpeedRatio));
            FluidSolverSettings.RequirePositive(input.MaxCompression, nameof(input.MaxCompression));
            FluidSolverSettings.RequirePositive(input.TimeStepFraction, nameof(input.TimeStepFraction));
            FluidSolverSettings.RequirePositive(input.WallDistanceRatio, nameof(input.WallDistanceRatio));
            FluidSolverSettings.RequirePositive(input.MinSpeed, nameof(input.MinSpeed));
            FluidSolverSettings.RequireNotNegative(input.Gravity.magnitude, nameof(input.Gravity));
            FluidSolverSettings.RequireNotNegative(input.LiquidHeight, nameof(input.LiquidHeight));
            FluidSolverSettings.RequireNotNegative(input.LiquidDepth, nameof(input.LiquidDepth));
            FluidSolverSettings.RequireNotNegative(input.InitialSpeed, nameof(input.InitialSpeed));
            FluidSolverSettings.RequireNotNegative(input.KinematicViscosity, nameof(input.KinematicViscosity));
            FluidSolverSettings.RequireNotNegative(input.ViscosityRatio, nameof(input.ViscosityRatio));
            FluidSolverSettings.RequireNotNegative(input.WallStiffnessRatio, nameof(input.WallStiffnessRatio));
            FluidSolverSettings.RequireNotNegative(input.WallDampingRatio, nameof(input.WallDampingRatio));
        }
    }
}
