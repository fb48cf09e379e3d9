using System;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Which viscosity acts where a profile is used, as its inspector shows it: a method needs a least one to stay calm.</summary>
    public static class ViscosityText
    {
        // A float and what the rules make of it differ by rounding.
        private const double Same = 1.0 + 1e-4;

        // Below this spacing nobody simulates.
        private const double FinestSpacing = 1e-3;

        /// <summary>Of a simulation with these constants.</summary>
        /// <param name="simulation">The simulation, with a profile.</param>
        /// <param name="constants">Its constants, present ones or those that it would start with.</param>
        /// <returns>One or two sentences.</returns>
        public static string Describe(FluidSimulation simulation, in FluidSolverSettings constants)
        {
            double set = simulation.Profile.KinematicViscosity, acts = constants.Viscosity / (double)constants.RestDensity;
            if (acts <= set * Same) return $"'{simulation.name}': {Number(acts)} m²/s acts, as set.{Cost(constants)}";
            string text =
                $"'{simulation.name}': {Number(acts)} m²/s acts, the least of its method at a spacing of {Length(constants.Spacing)}.";
            double spacing = constants.Spacing * set / acts;
            return spacing >= FinestSpacing ? $"{text} The {Number(set)} m²/s that are set act at {Length(spacing)} and finer." : text;
        }

        /// <summary>Of a profile that no simulation uses: by the method Standard, for a fall of a metre.</summary>
        /// <param name="profile">The profile.</param>
        /// <returns>A sentence.</returns>
        public static string Unused(FluidProfile profile)
        {
            double spacing = SpacingThatHonours(profile, 1f);
            const string start = "No simulation of the open scenes uses this profile. By the method Standard, for a fall of 1 m, ";
            if (double.IsInfinity(spacing)) return start + "its viscosity acts as set at any spacing.";
            return spacing >= FinestSpacing
                ? $"{start}its viscosity acts as set at a spacing of {Length(spacing)} and finer; coarser liquid is more viscous."
                : $"{start}the liquid is more viscous than set: {Number(Least(profile, 0.01f, 1f))} m²/s at a spacing of {Length(0.01)}.";
        }

        /// <summary>
        /// Largest spacing at which a profile's viscosity acts with the method Standard [m]; the least viscosity grows with the spacing.
        /// </summary>
        /// <param name="profile">The profile.</param>
        /// <param name="fall">Height of the liquid's top over the domain's lowest place [m].</param>
        /// <returns>The spacing; infinite where the profile asks for no least viscosity.</returns>
        internal static double SpacingThatHonours(FluidProfile profile, float fall)
        {
            const float spacing = 0.01f;
            double least = Least(profile, spacing, fall);
            return least > 0.0 ? spacing * profile.KinematicViscosity / least : double.PositiveInfinity;
        }

        private static double Least(FluidProfile profile, float spacing, float fall)
        {
            FluidRuleInput rules = profile.Spec.Rules;
            rules.Method = FluidMethodKind.Standard;
            rules.KinematicViscosity = 0f;
            rules.DomainSize = new Vector3(1f, fall, 1f);
            rules.Spacing = spacing;
            rules.LiquidHeight = rules.LiquidDepth = fall;
            FluidSolverSettings settings = FluidMethods.Get(FluidMethodKind.Standard).Derive(rules);
            return settings.Viscosity / (double)settings.RestDensity;
        }

        private static string Cost(in FluidSolverSettings constants)
        {
            TimeStepAdvice advice = FluidRules.Advise(constants, constants.MaxSpeed);
            string limits = advice.Limit == TimeStepLimit.Viscosity
                ? $" It sets the time step of {TimeStepAdvice.Milliseconds(constants.TimeStep)}." : "";
            if (!advice.ViscosityIsImplicit) return limits;
            int iterations = ImplicitViscosity.Iterations(constants, constants.TimeStep);
            return $" It is solved implicitly, in {iterations} iterations a " +
                $"step{(limits == "" ? ", and does not shorten the step." : "." + limits)}";
        }

        private static string Number(double viscosity) => FormattableString.Invariant($"{viscosity:G2}");

        private static string Length(double metres) =>
            metres < 0.1 ? FormattableString.Invariant($"{1e3 * metres:G2} mm") : FormattableString.Invariant($"{1e2 * metres:0} cm");
    }
}
