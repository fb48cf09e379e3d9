using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Says what of a level of detail a simulation cannot do.</summary>
    internal static class DetailChecks
    {
        // Of what longer steps gain: fast liquid takes some of it, as its speed sets the step too.
        private const double LeastGain = 0.4;

        /// <summary>Checks all levels.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">How it starts.</param>
        /// <param name="messages">Receives what a level asks for in vain.</param>
        public static void Check(in FluidSpec spec, FluidStart start, List<FluidMessage> messages)
        {
            for (int i = 0; i < (spec.Detail.Levels?.Count ?? 0); i++)
                if (Find(spec, start, i + 1) is FluidMessage found) messages.Add(found);
        }

        /// <summary>What a level asks for in vain; null: nothing.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">How it started.</param>
        /// <param name="number">The level, from 1 on.</param>
        public static FluidMessage? Find(in FluidSpec spec, FluidStart start, int number)
        {
            FluidDetailLevel level = spec.Detail.Levels[number - 1];
            if (level == null || !(level.StepFactor > 1f) || float.IsInfinity(level.StepFactor)) return null;
            string asks = FormattableString.Invariant($"Level {number} of detail asks for steps {level.StepFactor:0.##} times as long");
            FluidMethod method = FluidMethods.Get(spec.Method);
            if (spec.Playback != null) return Limited(spec, asks + ", and liquid that is played back takes none.", "Set Step Factor to 1.");
            if (spec.TimeStepMode == FluidTimeStepMode.Fixed)
            {
                return Limited(spec, asks + ", and Time Step Mode is Fixed: they stay as they are.",
                    "Set Time Step Mode to Automatic, or Step Factor to 1.");
            }
            double reached = StepDetail.Reached(spec, start, level.StepFactor);
            FluidRuleInput input = FluidConstants.Input(spec, start, start.Gravity);
            if (method.CoarsestReason(input, level.StepFactor, reached) is string reason)
            {
                return Limited(spec, asks + reason, method.CoarsestCure);
            }
            if (method.Has(FluidMethodFeatures.StepsByFrame)) return null;
            (double full, _) = StepOf(spec, start);
            (double coarse, TimeStepLimit limit) = StepOf(new StepDetail { Factor = reached }.AppliedTo(spec), start);
            return !(coarse / full < 1.0 + LeastGain * (level.StepFactor - 1.0)) ? (FluidMessage?)null
                : Limited(spec,
                    FormattableString.Invariant($"{asks}; the {TimeStepAdvice.NameOf(limit)} allows {coarse / full:0.##} times."),
                    "Lower Step Factor: it makes the liquid softer for little.");
        }

        private static (double step, TimeStepLimit limit) StepOf(in FluidSpec spec, FluidStart start)
        {
            FluidSolverSettings settings = FluidConstants.Derive(spec, start, start.Gravity);
            TimeStepAdvice advice = FluidRules.Advise(settings, settings.MaxSpeed);
            return (advice.Step(spec.Profile.Rules.TimeStepFraction), advice.Limit);
        }

        private static FluidMessage Limited(in FluidSpec spec, string text, string cure) =>
            new FluidMessage(FluidSeverity.Info, FluidIssue.DetailLimited, spec.Detail.Owner, text, cure);
    }
}
