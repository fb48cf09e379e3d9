using System;

namespace SphFluid.Editor
{
    /// <summary>
    /// Whether a profile's surface tension acts in a simulation, as the profile's inspector shows it: coarse particles do not resolve it.
    /// </summary>
    public static class SurfaceTensionText
    {
        /// <summary>Of a simulation with these constants.</summary>
        /// <param name="simulation">The simulation, with a profile.</param>
        /// <param name="constants">Its constants, present ones or those that it would start with.</param>
        /// <returns>A sentence or two; empty where the profile has no surface tension.</returns>
        public static string Describe(FluidSimulation simulation, in FluidSolverSettings constants)
        {
            FluidProfile profile = simulation.Profile;
            if (!(profile.SurfaceTension > 0f)) return "";
            string tension = FormattableString.Invariant($"surface tension of {profile.SurfaceTension:G2} N/m");
            if (!FluidMethods.Has(constants.Method, FluidMethodFeatures.SurfaceTension))
            {
                return $"'{simulation.name}': the {tension} does not act: the method {constants.Method} has none.";
            }
            TimeStepAdvice advice = FluidRules.Advise(constants, constants.MaxSpeed);
            if (double.IsInfinity(advice.SurfaceTension))
            {
                double gravity = constants.Gravity.magnitude,
                    spacing = 1e3 * CapillaryRules.ResolvedSpacing(profile.SurfaceTension, profile.RestDensity, gravity);
                string earth = gravity < 0.99 * CapillaryRules.EarthGravity ? " on Earth" : "";
                return FormattableString.Invariant(
                    $"'{simulation.name}': the {tension} does not act at a spacing of {1e3 * constants.Spacing:G2} mm. It does at ") +
                    FormattableString.Invariant($"{spacing:G2} mm and finer, the liquid's capillary length{earth}, or with Tension At ") +
                    "Any Spacing.";
            }
            string limits = advice.Limit == TimeStepLimit.SurfaceTension
                ? $" It sets the time step of {TimeStepAdvice.Milliseconds(constants.TimeStep)}." : "";
            return FormattableString.Invariant($"'{simulation.name}': the {tension} acts, with a contact angle of ") +
                FormattableString.Invariant($"{profile.ContactAngle:0}°.{limits}");
        }
    }
}
