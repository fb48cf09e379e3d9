using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The spacing at which a liquid that is too dear, or too soft, would be neither: the number of particles goes with the inverse cube of
    /// the spacing, the number of steps as the methods offer. It is only proposed.
    /// </summary>
    internal static class CoarserSpacing
    {
        private const double Growth = 1.02;

        // Of the present spacing: a liquid with a thousandth of its particles is another scene.
        private const double Most = 10.0;

        /// <summary>Adds the proposal to a choice, where there is one.</summary>
        public static void Propose(FluidMethodChoice choice, in FluidRuleInput input, bool hasBodies)
        {
            for (double ratio = Growth; ratio <= Most; ratio *= Growth)
            {
                FluidRuleInput coarser = input;
                coarser.Spacing = Round(input.Spacing * ratio);
                if (LosesForce(input, coarser)) return;
                long particles = (long)Math.Max(1.0, choice.Particles * Math.Pow(input.Spacing / (double)coarser.Spacing, 3.0));
                if (!(Fitting(choice, coarser, particles, hasBodies) is FluidMethodKind method)) continue;
                (choice.ProposedSpacing, choice.ProposedParticles, choice.ProposedMethod) = (coarser.Spacing, particles, method);
                return;
            }
        }

        private static FluidMethodKind? Fitting(FluidMethodChoice choice, in FluidRuleInput input, long particles, bool hasBodies)
        {
            var asked = new HashSet<FluidMethodKind>();
            foreach (FluidMethodCandidate candidate in choice.Considered)
            {
                if (candidate.Obstacle != null || double.IsNaN(candidate.MillisecondsAStep) || !asked.Add(candidate.Method)) continue;
                double cost = candidate.CostSource == FluidCostSource.Estimated ? StepCosts.Estimate(candidate.Method, particles)
                    : StepCosts.TryFind(StepCostKey.Create(FluidMethods.Get(candidate.Method).Derive(candidate.Offer.Apply(input)),
                        hasBodies), particles, out StepCost known) ? known.Milliseconds : double.NaN;
                foreach (MethodOffer offer in MethodChooser.Offers(FluidMethods.Get(candidate.Method), input, choice.Asked, cost))
                    if (offer.StepsAFrame * offer.CostRatio * cost <= choice.FrameBudget && offer.SoundSpeed >= offer.LeastSoundSpeed)
                    {
                        return candidate.Method;
                    }
            }
            return null;
        }

        // A liquid in which a force acts no more is another liquid.
        private static bool LosesForce(in FluidRuleInput input, in FluidRuleInput coarser)
        {
            FluidMethodFeatures lost = MethodObstacles.AskedBy(input) & ~MethodObstacles.AskedBy(coarser);
            foreach (FluidMethod method in FluidMethods.All)
                if ((lost & method.ForceFeatures) != 0) return true;
            return false;
        }

        // To three digits, as users type it: 0.031234 m to 0.0312.
        private static float Round(double spacing)
        {
            double digit = Math.Pow(10.0, Math.Floor(Math.Log10(spacing)) - 2.0);
            return (float)(Math.Ceiling(spacing / digit - 1e-6) * digit);
        }
    }
}
