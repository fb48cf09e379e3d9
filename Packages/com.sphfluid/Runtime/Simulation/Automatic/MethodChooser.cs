using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Times the steps of a method that is not known yet; null: not now.</summary>
    /// <param name="settings">Constants for the method.</param>
    internal delegate StepCost? StepMeter(in FluidSolverSettings settings);

    /// <summary>
    /// Chooses the method of a simulation by the rule of the paper <i>Automatic</i>: the Standard method as the profile asks, else with
    /// three times the compression, else a method with a fixed number of steps; each by what its steps cost on this device.
    /// </summary>
    internal static class MethodChooser
    {
        /// <summary>Chooses.</summary>
        /// <param name="resolved">The simulation, by an earlier choice or none.</param>
        /// <param name="start">Where its liquid starts.</param>
        /// <param name="hasBodies">Whether there are triangles in its domain.</param>
        /// <param name="meter">Times what is not known; null: it stays unknown.</param>
        /// <param name="present">The choice in use; null: none.</param>
        /// <param name="only">The only method to choose; null: any.</param>
        /// <returns>The choice; null where no method can be picked.</returns>
        /// <exception cref="ArgumentException">An input of the rules is out of range.</exception>
        public static FluidMethodChoice Choose(in FluidSpec resolved, FluidStart start, bool hasBodies, StepMeter meter,
            FluidMethodChoice present = null, FluidMethodKind? only = null)
        {
            FluidSpec spec = resolved.AsSet();
            FluidRuleInput input = FluidConstants.Input(spec, start, start.Gravity);
            long particles = ParticlesOf(spec, start);
            var candidates = new List<FluidMethodCandidate>();
            foreach (FluidMethod method in FluidMethods.All)
            {
                if (!method.MayBePicked || only.HasValue && method.Kind != only.Value) continue;
                Add(candidates, spec, input, method, particles, hasBodies, meter);
                int fits = MethodRule.Pick(candidates, spec.Automatic.Budget, RankOf(present, candidates));
                if (fits >= 0 && candidates[fits].MillisecondsAFrame <= spec.Automatic.Budget) break;
            }
            int pick = MethodRule.Pick(candidates, spec.Automatic.Budget, RankOf(present, candidates));
            if (pick < 0) return null;
            var choice = new FluidMethodChoice(spec.Automatic, particles, candidates, pick);
            if (choice.IsMeasured && !(choice.FitsBudget && choice.Pick.IsStiffEnough)) CoarserSpacing.Propose(choice, input, hasBodies);
            return choice;
        }

        /// <summary>The ways of a method for an input, with what a number of particles costs.</summary>
        internal static IReadOnlyList<MethodOffer> Offers(FluidMethod method, in FluidRuleInput input, in AutomaticSpec asked,
            double millisecondsAStep) =>
                method
                    .Offers(new MethodQuestion
                    {
                        Input = input, FrameTime = 1.0 / asked.FrameRate,
                        Affordable = asked.Budget / millisecondsAStep
                    });

        private static void Add(List<FluidMethodCandidate> candidates, in FluidSpec spec, in FluidRuleInput input, FluidMethod method,
            long particles, bool hasBodies, StepMeter meter)
        {
            IReadOnlyList<MethodOffer> offers = Offers(method, input, spec.Automatic, double.NaN);
            if (offers.Count == 0) return;
            string obstacle = MethodObstacles.Find(spec, input, method);
            double cost = obstacle == null ? CostOf(method, input, offers[0], particles, hasBodies, meter, out FluidCostSource source)
                : Unknown(out source);
            foreach (MethodOffer offer in Offers(method, input, spec.Automatic, cost))
            {
                candidates.Add(new FluidMethodCandidate(offer, cost, source, obstacle));
            }
        }

        private static double CostOf(FluidMethod method, in FluidRuleInput input, in MethodOffer offer, long particles, bool hasBodies,
            StepMeter meter, out FluidCostSource source)
        {
            if (particles == 0) return Unknown(out source);
            FluidSolverSettings settings = method.Derive(offer.Apply(input));
            StepCostKey key = StepCostKey.Create(settings, hasBodies);
            bool known = StepCosts.TryFind(key, particles, out StepCost cost) && StepCostTable.IsNear(cost, particles);
            if (!known && meter != null)
            {
                if (!(meter(settings) is StepCost measured))
                {
                    source = FluidCostSource.Estimated;
                    return StepCosts.Estimate(method.Kind, particles);
                }
                measured.Milliseconds *= method.PassesAStep / method.PassesOf(settings, settings.TimeStep, settings.MaxSpeed);
                StepCosts.Record(key, measured);
                known = StepCosts.TryFind(key, particles, out cost);
            }
            if (!known) return Unknown(out source);
            source = cost.InPlay ? FluidCostSource.MeasuredInPlay : FluidCostSource.MeasuredAtStart;
            return cost.Milliseconds;
        }

        private static double Unknown(out FluidCostSource source)
        {
            source = FluidCostSource.Unknown;
            return double.NaN;
        }

        // Those that a simulation with a fixed number of slots can come to; else those of the start.
        private static long ParticlesOf(in FluidSpec spec, FluidStart start) =>
            spec.Emitters?.Count > 0 && spec.CapacityPolicy != FluidCapacityPolicy.Grow &&
                spec.Capacity > 0 ? Math.Max(start.Count, spec.MostParticles) : start.Count;

        private static int RankOf(FluidMethodChoice present, List<FluidMethodCandidate> candidates)
        {
            if (present == null) return -1;
            for (int i = 0; i < candidates.Count; i++)
                if (candidates[i].Method == present.Method && candidates[i].MaxCompression.Equals(present.Pick.MaxCompression)) return i;
            return -1;
        }
    }
}
