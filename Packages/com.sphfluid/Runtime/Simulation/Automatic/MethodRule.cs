using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Which of several ways to compute a liquid: the first, in the order from the most faithful down, whose frame fits the budget; where
    /// none does, the first that costs about as little as the cheapest. Of those that fit a larger budget therefore never picks one further
    /// down. Where one is in use that still fits, one above it has to fit with some to spare.
    /// </summary>
    internal static class MethodRule
    {
        /// <summary>
        /// Share of the budget that one above the present pick must fit, so that costs that waver do not change the pick to and fro.
        /// </summary>
        public const double ReturnShare = 0.9;

        /// <summary>How many times the cheapest one's cost is about as little, where none fits: timed costs waver by so much.</summary>
        public const double AboutAsCheap = 1.25;

        /// <summary>Picks.</summary>
        /// <param name="candidates">The ways, the most faithful first.</param>
        /// <param name="budget">Time allowed for a frame's steps [ms].</param>
        /// <param name="present">The one in use; -1: none.</param>
        /// <returns>Its place in the list; -1 where none can be picked.</returns>
        public static int Pick(IReadOnlyList<FluidMethodCandidate> candidates, double budget, int present = -1)
        {
            int first = -1;
            double least = double.PositiveInfinity;
            bool stays = present >= 0 && candidates[present].Obstacle == null && Fits(candidates[present], budget);
            for (int i = 0; i < candidates.Count; i++)
            {
                FluidMethodCandidate candidate = candidates[i];
                if (candidate.Obstacle != null) continue;
                if (first < 0) first = i;
                if (double.IsNaN(candidate.MillisecondsAFrame)) continue;
                if (Fits(candidate, stays && i < present ? ReturnShare * budget : budget)) return i;
                least = Math.Min(least, candidate.MillisecondsAFrame);
            }
            for (int i = 0; i < candidates.Count; i++)
                if (candidates[i].Obstacle == null && candidates[i].MillisecondsAFrame <= AboutAsCheap * least) return i;
            return first;
        }

        /// <summary>Whether a candidate's frame fits a budget [ms].</summary>
        public static bool Fits(in FluidMethodCandidate candidate, double budget) => candidate.MillisecondsAFrame <= budget;
    }
}
