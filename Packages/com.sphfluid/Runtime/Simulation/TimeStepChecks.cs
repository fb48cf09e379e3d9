using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Rules about a time step that the user gives.</summary>
    internal static class TimeStepChecks
    {
        /// <summary>Warns where the fixed step is above what is stable at the fastest expected speed.</summary>
        public static void Check(in FluidSpec spec, in FluidSolverSettings settings, List<FluidMessage> messages)
        {
            if (spec.TimeStepMode != FluidTimeStepMode.Fixed) return;
            TimeStepAdvice advice = FluidRules.Advise(settings, settings.MaxSpeed);
            if (settings.TimeStep <= advice.Largest) return;
            double better = RoundedDown(advice.Step(spec.Profile.Rules.TimeStepFraction));
            messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.TimeStepInvalid, spec.Owner,
                $"The fixed time step of {TimeStepAdvice.Milliseconds(settings.TimeStep)} is above the stability limit of {TimeStepAdvice.Milliseconds(advice.Largest)}, " +
                $"which {advice.Cause}, so {Consequence(advice.Limit)}.",
                FormattableString.Invariant($"Use a Fixed Time Step of {better} s, or set Time Step Mode to Automatic; {advice.Cure}.")));
        }

        static string Consequence(TimeStepLimit limit)
        {
            switch (limit)
            {
                case TimeStepLimit.Speed: return "particles can pass through walls";
                case TimeStepLimit.Walls: return "walls will throw particles back";
                default: return "the liquid will fly apart";
            }
        }

        // To two digits: 0.00053871 to 0.00053.
        static double RoundedDown(double step)
        {
            double digit = Math.Pow(10.0, Math.Floor(Math.Log10(step)) - 1.0);
            return Math.Round(Math.Floor(step / digit) * digit, 15);
        }
    }
}
