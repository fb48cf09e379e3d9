using System.Collections.Generic;
using System.Text;
using UnityEngine;
using static System.FormattableString;

namespace SphFluid
{
    /// <summary>A choice in words, with its figures; the same in the console, the inspector and the files of a play.</summary>
    internal static class MethodChoiceText
    {
        /// <summary>How a cure begins that proposes a spacing.</summary>
        public const string SpacingCure = "Set Particle Spacing to ";

        /// <summary>What was picked and why.</summary>
        public static string Reason(FluidMethodChoice choice)
        {
            if (choice.IsRestored) return $"{Name(choice.Pick)}, as the save has it.";
            if (!choice.IsMeasured) return $"{Name(choice.Pick)} for now: what a step costs on this device is measured at the start.";
            var text = new StringBuilder();
            text.Append(choice.FitsBudget
                ? Invariant($"{Name(choice.Pick)}, {Steps(choice.Pick)}: {Time(choice.Pick)} of the {choice.FrameBudget:0.##} ms ") +
                    Invariant($"allowed at {choice.FrameRate:0.#} frames a second.")
                : Invariant($"{Name(choice.Pick)}, {Steps(choice.Pick)}: {Time(choice.Pick)}, more than the {choice.FrameBudget:0.##} ") +
                    Invariant($"ms allowed at {choice.FrameRate:0.#} frames a second. No way is cheaper by more than a fifth; the ") +
                    "liquid keeps time, and frames take longer.");
            int others = choice.FitsBudget ? choice.Rank : choice.Considered.Count;
            for (int i = 0; i < others; i++)
                if (i != choice.Rank && Other(choice.Considered[i]) is string other) text.Append(' ').Append(other);
            if (choice.Pick.Substeps > 0 && choice.Pick.IsStiffEnough)
            {
                text.Append(Invariant($" Its speed of sound is {choice.Pick.SoundSpeed:0.#} m/s."));
            }
            if (!choice.Pick.IsStiffEnough)
            {
                text.Append(
                    Invariant($" At a speed of sound of {choice.Pick.SoundSpeed:0.#} m/s it is too soft for this depth, which needs ") +
                    Invariant($"{choice.Pick.Offer.LeastSoundSpeed:0.#} m/s: it sinks in."));
            }
            return text.Append(' ').Append(Source(choice)).ToString();
        }

        /// <summary>Robust, 4 substeps a frame, 3.81 ms of 4 ms.</summary>
        public static string Short(FluidMethodChoice choice) => choice.IsRestored || !choice.IsMeasured ? Name(choice.Pick)
            : Invariant($"{Name(choice.Pick)}, {Steps(choice.Pick)}, {Time(choice.Pick)} of {choice.FrameBudget:0.##} ms");

        /// <summary>What to do about a choice that does not fit; empty where nothing needs doing.</summary>
        public static string Cure(FluidMethodChoice choice)
        {
            if (!choice.IsMeasured || choice.IsRestored || choice.FitsBudget && choice.Pick.IsStiffEnough) return "";
            string spacing = choice.ProposedSpacing > 0f
                ? SpacingCure +
                    Invariant($"{choice.ProposedSpacing} m, which gives about {choice.ProposedParticles:N0} particles and fits by the ") +
                    Invariant($"method {choice.ProposedMethod}") : "";
            string budget = choice.FitsBudget ? "raise Frame Budget"
                : Invariant($"allow a Frame Budget of {Up(choice.Pick.MillisecondsAFrame)} ms");
            return spacing.Length > 0 ? $"{spacing}, or {budget}." : $"{char.ToUpperInvariant(budget[0])}{budget.Substring(1)}.";
        }

        /// <summary>The message of a decision.</summary>
        public static FluidMessage Message(FluidMethodChoice choice, Object owner)
        {
            string cure = Cure(choice);
            return new FluidMessage(cure.Length > 0 ? FluidSeverity.Warning : FluidSeverity.Info, FluidIssue.MethodChoice, owner,
                "Method in use: " + Reason(choice), cure);
        }

        /// <summary>The message where no method can be picked.</summary>
        /// <param name="spec">The simulation, by the method that it runs by nevertheless.</param>
        /// <param name="obstacles">Why not, as sentences.</param>
        public static FluidMessage NoneMessage(in FluidSpec spec, string obstacles) =>
            new FluidMessage(FluidSeverity.Warning, FluidIssue.MethodChoice, spec.Owner,
            $"No method has all that the simulation uses: it runs by {spec.Method}, without some of it. {obstacles}",
            "Remove what is missing from the simulation or its profile, or set Method yourself.");

        /// <summary>Standard; Standard with 12 % compression; Robust.</summary>
        public static string Name(in FluidMethodCandidate candidate) => candidate.Substeps > 0 || candidate.Offer.AsTheProfileAsks
            ? $"{candidate.Method}" : Invariant($"{candidate.Method} with {100.0 * candidate.MaxCompression:0.#} % compression");

        /// <summary>15 steps a frame at most; 4 substeps a frame.</summary>
        public static string Steps(in FluidMethodCandidate candidate) => candidate.Substeps > 0
            ? Invariant($"{candidate.Substeps} substeps a frame") : Invariant($"{candidate.StepsAFrame:0} steps a frame at most");

        private static string Time(in FluidMethodCandidate candidate) => Invariant($"{candidate.MillisecondsAFrame:0.00} ms");

        private static string Other(in FluidMethodCandidate candidate) =>
            candidate.Obstacle != null ? (candidate.Offer.AsTheProfileAsks ? $"{candidate.Method} {candidate.Obstacle}." : null) :
            double.IsNaN(candidate.MillisecondsAFrame)
            ? (candidate.Offer.AsTheProfileAsks ? $"{candidate.Method} is not timed yet; the start does that." : null) :
            candidate.Substeps > 0 ? Invariant($"{Name(candidate)} would take {candidate.Substeps} substeps = {Time(candidate)}.")
            : Invariant($"{Name(candidate)} would take {candidate.StepsAFrame:0} steps = {Time(candidate)}.");

        private static string Source(FluidMethodChoice choice)
        {
            string liquid = Invariant($"{choice.Particles:N0} particles on {SystemInfo.graphicsDeviceName}");
            switch (Least(choice.Considered))
            {
                case FluidCostSource.Estimated: return $"For {liquid}, which could not be timed: the costs are estimates.";
                case FluidCostSource.MeasuredAtStart: return $"For {liquid}, timed at a start.";
                default: return $"For {liquid}, timed in play.";
            }
        }

        private static FluidCostSource Least(IReadOnlyList<FluidMethodCandidate> considered)
        {
            FluidCostSource least = FluidCostSource.MeasuredInPlay;
            foreach (FluidMethodCandidate candidate in considered)
                if (candidate.CostSource != FluidCostSource.Unknown && candidate.CostSource < least) least = candidate.CostSource;
            return least;
        }

        // Two digits that are no less: 5.04 to 5.1.
        private static double Up(double milliseconds)
        {
            double digit = System.Math.Pow(10.0, System.Math.Floor(System.Math.Log10(milliseconds)) - 1.0);
            return System.Math.Round(System.Math.Ceiling(milliseconds / digit) * digit, 6);
        }
    }
}
