using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Which runs a chart is made of, in their order, within a budget that all cases and methods share: an expensive case gets coarser or
    /// fewer points and takes nothing from others. The first run of each case and method comes first, then the second, ..., so that a chart
    /// that is stopped early has every panel.
    /// </summary>
    public sealed class ChartPlan
    {
        /// <summary>
        /// Work of the whole short plan: seven minutes of llvmpipe on two cores; start, pictures and surprises have the rest of ten.
        /// </summary>
        internal const double QuickBudget = 420.0 * StepWork.SoftwareRate;

        // Time of a full chart; the costs of steps and the pictures come on top.
        private const double FullSeconds = 50.0 * 60.0;

        /// <summary>Most work of one run on a software device, five minutes: a slice of eight holds it.</summary>
        internal const double SoftwareRunLimit = 300.0 * StepWork.SoftwareRate;

        private readonly List<ChartRun> runs = new List<ChartRun>();
        private readonly List<ChartConfig> unbuildable = new List<ChartConfig>();
        private readonly List<ChartRun> leftOut = new List<ChartRun>();

        private ChartPlan(IReadOnlyList<StepCostPoint> stepCosts) => StepCosts = stepCosts;

        /// <summary>The runs in their order.</summary>
        public IReadOnlyList<ChartRun> Runs => runs;

        /// <summary>Liquids whose step is timed beside the cases.</summary>
        public IReadOnlyList<StepCostPoint> StepCosts { get; }

        /// <summary>Points that their case cannot be set up at.</summary>
        public IReadOnlyList<ChartConfig> Unbuildable => unbuildable;

        /// <summary>Runs that would take too long on this device, or do not fit into the plan's time.</summary>
        public IReadOnlyList<ChartRun> LeftOut => leftOut;

        /// <summary>Work of all runs.</summary>
        public double Cost => runs.Sum(r => r.Cost);

        /// <summary>Work of a full chart: 50 minutes of a software device on two cores, or of a graphics card.</summary>
        internal static double FullBudget(bool isSoftware) => FullSeconds * (isSoftware ? StepWork.SoftwareRate : StepWork.CardRate);

        /// <summary>What is left out in a few words, for instance "the time step of marin; further seeds".</summary>
        public string DescribeLeftOut()
        {
            var kept = new HashSet<string>(runs.Select(r => r.Config.Key));
            List<ChartConfig> lost = leftOut.Select(r => r.Config).Where(c => !kept.Contains(c.Key)).ToList();
            IEnumerable<string> factors = lost.GroupBy(c => c.Factor).OrderBy(g => g.Key).Select(g =>
                $"{ChartStyle.Title(g.Key)} of {string.Join(", ", g.Select(c => c.Case.Name).Distinct())}");
            bool seeds = leftOut.Any(r => kept.Contains(r.Config.Key));
            return string.Join("; ", seeds ? factors.Append("further seeds") : factors);
        }

        /// <summary>All sweeps, with three seeds at every point and five at the bases, as far as the budget goes.</summary>
        /// <param name="cases">The cases.</param>
        /// <param name="methods">The methods.</param>
        /// <param name="budget">Work of the whole plan.</param>
        /// <param name="runLimit">Most work of a run; longer ones are left out.</param>
        /// <param name="stepCosts">Liquids whose step is timed; null for none.</param>
        public static ChartPlan Full(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods,
            double budget = double.PositiveInfinity, double runLimit = double.PositiveInfinity,
            IReadOnlyList<StepCostPoint> stepCosts = null) =>
                Of(cases, methods, budget, runLimit, (c, m, share) => ChartSweep.Full(c, m), stepCosts);

        /// <summary>
        /// The most telling runs that fit into the budget: spacings and supports of the methods that users choose, the base of the others,
        /// and seeds of the cheap points.
        /// </summary>
        /// <param name="cases">The cases.</param>
        /// <param name="methods">The methods.</param>
        /// <param name="budget">Work of the whole plan.</param>
        /// <param name="stepCosts">Liquids whose step is timed; null for none.</param>
        public static ChartPlan Quick(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods, double budget = QuickBudget,
            IReadOnlyList<StepCostPoint> stepCosts = null) =>
                Of(cases, methods, budget, double.PositiveInfinity, ChartSweep.Quick, stepCosts);

        private static ChartPlan Of(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods, double budget, double runLimit,
            Func<ValidationCase, CaseMethod, double, IEnumerable<ChartRun>> sweep, IReadOnlyList<StepCostPoint> stepCosts)
        {
            var plan = new ChartPlan(stepCosts ?? Array.Empty<StepCostPoint>());
            double weights = cases.Count * methods.Sum(ChartSweep.Weight);
            var kept = new List<List<ChartRun>>();
            var waiting = new List<List<ChartRun>>();
            double left = budget;
            foreach (ValidationCase validationCase in cases)
            {
                foreach (CaseMethod method in methods)
                {
                    double share = budget * ChartSweep.Weight(method) / weights;
                    List<ChartRun> wanted = plan.Distinct(sweep(validationCase, method, share));
                    plan.leftOut.AddRange(wanted.Where(r => r.Cost > runLimit));
                    wanted.RemoveAll(r => r.Cost > runLimit);
                    List<ChartRun> own = Within(wanted, share);
                    kept.Add(own);
                    waiting.Add(wanted.Except(own).ToList());
                    left -= own.Sum(r => r.Cost);
                }
            }
            // What one case leaves goes to the others, in turn.
            foreach ((int list, ChartRun run) in InTurn(waiting))
            {
                bool fits = run.Cost <= left;
                (fits ? kept[list] : plan.leftOut).Add(run);
                left -= fits ? run.Cost : 0.0;
            }
            plan.runs.AddRange(InTurn(kept).Select(r => r.Run));
            return plan;
        }

        private List<ChartRun> Distinct(IEnumerable<ChartRun> wanted)
        {
            var taken = new HashSet<string>();
            var result = new List<ChartRun>();
            foreach (ChartRun run in wanted)
            {
                if (run.Config.Problem == null)
                {
                    if (taken.Add(run.Key)) result.Add(run);
                }
                else if (!unbuildable.Contains(run.Config))
                {
                    unbuildable.Add(run.Config);
                }
            }
            return result;
        }

        // In their order, without those that do not fit; the cheapest alone where none does, so that each panel has a point.
        private static List<ChartRun> Within(List<ChartRun> wanted, double share)
        {
            var result = new List<ChartRun>();
            double cost = 0.0;
            foreach (ChartRun run in wanted.Where(r => cost + r.Cost <= share))
            {
                result.Add(run);
                cost += run.Cost;
            }
            if (result.Count == 0 && wanted.Count > 0) result.Add(wanted.OrderBy(r => r.Cost).First());
            return result;
        }

        // The first of every list, then the second, ...
        private static IEnumerable<(int List, ChartRun Run)> InTurn(List<List<ChartRun>> lists)
        {
            int longest = lists.Count == 0 ? 0 : lists.Max(l => l.Count);
            for (int i = 0; i < longest; i++)
            {
                for (int list = 0; list < lists.Count; list++)
                {
                    if (i < lists[list].Count) yield return (list, lists[list][i]);
                }
            }
        }
    }
}
