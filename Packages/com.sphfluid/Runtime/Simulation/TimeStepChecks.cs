using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Rules about a time step that the user gives.</summary>
    internal static class TimeStepChecks
    {
        // A float that is as long as the limit: 0.0012 s, as it is proposed.
        private const double RoundingSlack = 1.0 + 1e-6;

        /// <summary>
        /// Warns where the fixed step, or that of frames of 1/60 s, is above what is stable at the fastest expected speed.
        /// </summary>
        public static void Check(in FluidSpec spec, in FluidSolverSettings settings, List<FluidMessage> messages)
        {
            bool byFrame = spec.TimeStepMode != FluidTimeStepMode.Fixed;
            if (byFrame && !FluidMethods.Has(spec.Method, FluidMethodFeatures.StepsByFrame)) return;
            TimeStepAdvice advice = FluidRules.Advise(settings, settings.MaxSpeed);
            if (settings.TimeStep <= advice.Largest * RoundingSlack) return;
            if (byFrame)
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.TimeStepInvalid, spec.Owner,
                    $"Steps of {TimeStepAdvice.Milliseconds(settings.TimeStep)}, which frames of 1/60 s are cut into, are longer than " +
                    $"the {TimeStepAdvice.Milliseconds(advice.Largest)} " +
                    $"in which the method {spec.Method} carries liquid of this depth, so {Consequence(advice.Limit)}.",
                    "Raise the profile's Substeps to " +
                    FormattableString.Invariant($"{Math.Ceiling(spec.Profile.Rules.Substeps * settings.TimeStep / advice.Largest)} or ") +
                    "more, or use a larger Particle Spacing."));
                return;
            }
            double better = RoundedDown(advice.Step(spec.Profile.Rules.TimeStepFraction));
            messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.TimeStepInvalid, spec.Owner,
                $"The fixed time step of {TimeStepAdvice.Milliseconds(settings.TimeStep)} is above the stability limit of " +
                $"{TimeStepAdvice.Milliseconds(advice.Largest)}, " +
                $"which {advice.Cause}, so {Consequence(advice.Limit)}.",
                FormattableString.Invariant($"Use a Fixed Time Step of {better} s, or set Time Step Mode to Automatic; {advice.Cure}.")));
        }

        private static string Consequence(TimeStepLimit limit)
        {
            switch (limit)
            {
                case TimeStepLimit.Speed: return "particles can pass through walls";
                case TimeStepLimit.Weight: return "it sinks in under its own weight";
                case TimeStepLimit.Walls: return "walls will throw particles back";
                default: return "the liquid will fly apart";
            }
        }

        /// <summary>To two digits: 0.00053871 to 0.00053.</summary>
        internal static double RoundedDown(double step)
        {
            double digit = Math.Pow(10.0, Math.Floor(Math.Log10(step)) - 1.0);
            return Math.Round(Math.Floor(step / digit) * digit, 15);
        }
    }
}
