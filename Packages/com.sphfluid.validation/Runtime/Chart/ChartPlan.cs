using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Which runs a chart is made of, in their order: about each case's base one factor is changed at a time. The bases of all
    /// cases come first, so that a chart that is stopped early has every panel.
    /// </summary>
    public sealed class ChartPlan
    {
        /// <summary>Seeds of a base, and of a base of the short plan.</summary>
        internal const int BaseSeeds = 5, QuickBaseSeeds = 3;

        /// <summary>Seeds of the other points; one in the short plan.</summary>
        internal const int SweepSeeds = 3;

        /// <summary>Work a second of llvmpipe on two cores.</summary>
        internal const double SoftwareRate = 0.5e6;

        /// <summary>Work of the whole short plan: eight minutes of llvmpipe on two cores.</summary>
        internal const double QuickBudget = 480.0 * SoftwareRate;

        /// <summary>Most work of one run on a software device, five minutes: a slice of eight holds it.</summary>
        internal const double SoftwareRunLimit = 300.0 * SoftwareRate;

        static readonly double[] spacings = { 0.5, 0.67, 1.5, 2.0 };
        static readonly double[] supports = { 1.75, 2.0, 2.25, 2.5, 3.0 };
        static readonly double[] timeSteps = { 0.25, 0.5, 0.75 };
        static readonly double[] soundSpeeds = { 0.5, 2.0 };

        // From fine to coarse.
        static readonly double[] quickSpacings = { 0.67, 0.5 };

        // κ of the Standard method that a user chooses among; of the thesis method one besides its base.
        static readonly double[] standardSupports = { 2.0, 2.25, 2.5 }, thesisSupports = { 2.5 };

        readonly List<ChartRun> runs = new List<ChartRun>();
        readonly List<ChartConfig> unbuildable = new List<ChartConfig>();
        readonly List<ChartRun> leftOut = new List<ChartRun>();

        ChartPlan()
        {
        }

        /// <summary>The runs in their order.</summary>
        public IReadOnlyList<ChartRun> Runs => runs;

        /// <summary>Points that their case cannot be set up at.</summary>
        public IReadOnlyList<ChartConfig> Unbuildable => unbuildable;

        /// <summary>Runs that would take too long on this device, or do not fit into the short plan's time.</summary>
        public IReadOnlyList<ChartRun> LeftOut => leftOut;

        /// <summary>Work of all runs.</summary>
        public double Cost => runs.Sum(r => r.Cost);

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

        /// <summary>All sweeps: 5 seeds at the base, 3 elsewhere.</summary>
        /// <param name="cases">The cases.</param>
        /// <param name="methods">The methods.</param>
        /// <param name="runLimit">Most work of a run; longer ones are left out.</param>
        public static ChartPlan Full(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods, double runLimit = double.PositiveInfinity)
        {
            var plan = new ChartPlan();
            List<ChartConfig> bases = plan.Buildable(Bases(cases, methods));
            List<ChartConfig> others = plan.Buildable(RoundRobin(cases, methods, Sweeps));
            foreach (ChartRun run in Seeded(bases, 1, 1).Concat(Seeded(bases, 2, BaseSeeds)).Concat(Seeded(others, 1, SweepSeeds)))
                (run.Cost <= runLimit ? plan.runs : plan.leftOut).Add(run);
            return plan;
        }

        /// <summary>
        /// The most telling runs that fit into the budget: the bases first, or where a base would take more than its share, the
        /// finest coarser spacing that does not; then the Standard method's supports, among which its users choose, spacings, a point of each
        /// other factor, and further seeds of the bases. The thesis as printed has its base alone.
        /// </summary>
        /// <param name="cases">The cases.</param>
        /// <param name="methods">The methods.</param>
        /// <param name="budget">Work of the whole plan.</param>
        public static ChartPlan Quick(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods, double budget = QuickBudget)
        {
            var plan = new ChartPlan();
            double share = budget / Math.Max(1, cases.Count * methods.Count);
            List<ChartConfig> bases = plan.Buildable(Bases(cases, methods));
            List<ChartConfig> others = plan.Buildable(RoundRobin(cases, methods, QuickSweeps));
            List<ChartConfig> first = bases.Select(b => Affordable(b, share)).ToList();
            IEnumerable<ChartRun> candidates = Seeded(first, 1, 1).Concat(Seeded(others, 1, 1)).Concat(Seeded(bases.Where(IsSwept), 1, QuickBaseSeeds));
            var taken = new HashSet<string>();
            double cost = 0.0;
            foreach (ChartRun run in candidates.Where(r => taken.Add(r.Key)))
            {
                bool fits = cost + run.Cost <= budget;
                (fits ? plan.runs : plan.leftOut).Add(run);
                cost += fits ? run.Cost : 0.0;
            }
            return plan;
        }

        static ChartConfig Affordable(ChartConfig start, double share)
        {
            if (new ChartRun(start, 1).Cost <= share)
                return start;
            List<ChartConfig> coarser = Points(start.Case, start.Parameters(1), ChartFactor.Spacing, quickSpacings).Where(c => c.Problem == null).ToList();
            return coarser.FirstOrDefault(c => new ChartRun(c, 1).Cost <= share) ?? coarser.LastOrDefault() ?? start;
        }

        static bool IsSwept(ChartConfig config) => config.Method.Kind != FluidMethodKind.ThesisPrinted;

        List<ChartConfig> Buildable(IEnumerable<ChartConfig> configs)
        {
            var buildable = new List<ChartConfig>();
            foreach (ChartConfig config in configs)
                (config.Problem == null ? buildable : unbuildable).Add(config);
            return buildable;
        }

        static IEnumerable<ChartConfig> Bases(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods) =>
            from c in cases from m in methods select new ChartConfig(c, c.Base(m), ChartFactor.Base);

        // The first point of every case and method, then the second, ...
        static IEnumerable<ChartConfig> RoundRobin(IReadOnlyList<ValidationCase> cases, IReadOnlyList<CaseMethod> methods,
            Func<ValidationCase, CaseMethod, IEnumerable<ChartConfig>> sweep)
        {
            List<List<ChartConfig>> sweeps = (from c in cases from m in methods select sweep(c, m).ToList()).ToList();
            int longest = sweeps.Count == 0 ? 0 : sweeps.Max(s => s.Count);
            for (int i = 0; i < longest; i++)
            {
                foreach (List<ChartConfig> points in sweeps.Where(s => i < s.Count))
                    yield return points[i];
            }
        }

        static IEnumerable<ChartConfig> Sweeps(ValidationCase validationCase, CaseMethod method)
        {
            CaseParameters start = validationCase.Base(method);
            return Points(validationCase, start, ChartFactor.Spacing, spacings)
                .Concat(Points(validationCase, start, ChartFactor.Support, supports))
                .Concat(Points(validationCase, start, ChartFactor.TimeStep, timeSteps))
                .Concat(Points(validationCase, start, ChartFactor.SoundSpeed, soundSpeeds));
        }

        static IEnumerable<ChartConfig> QuickSweeps(ValidationCase validationCase, CaseMethod method)
        {
            CaseParameters start = validationCase.Base(method);
            if (method.Kind == FluidMethodKind.ThesisPrinted)
                return Enumerable.Empty<ChartConfig>();
            IEnumerable<ChartConfig> spacing = Points(validationCase, start, ChartFactor.Spacing, quickSpacings);
            IEnumerable<ChartConfig> leading = method.Kind == FluidMethodKind.Standard
                ? Points(validationCase, start, ChartFactor.Support, standardSupports).Concat(spacing)
                : spacing.Concat(Points(validationCase, start, ChartFactor.Support, thesisSupports));
            return leading.Concat(Points(validationCase, start, ChartFactor.SoundSpeed, 0.5))
                .Concat(Points(validationCase, start, ChartFactor.TimeStep, 0.5, 0.75).Take(1));
        }

        static IEnumerable<ChartConfig> Points(ValidationCase validationCase, CaseParameters start, ChartFactor factor, params double[] values)
        {
            foreach (double value in values)
            {
                CaseParameters point = start;
                switch (factor)
                {
                    case ChartFactor.Spacing:
                        point.Resolution = (int)Math.Round(start.Resolution * value);
                        break;
                    case ChartFactor.Support:
                        point.SupportRatio = value;
                        break;
                    case ChartFactor.TimeStep:
                        point.TimeStepFraction = value;
                        break;
                    case ChartFactor.SoundSpeed:
                        point.SoundSpeedRatio = start.SoundSpeedRatio * value;
                        break;
                }
                if (!IsSame(point, start) && point.Resolution > 0)
                    yield return new ChartConfig(validationCase, point, factor);
            }
        }

        static bool IsSame(in CaseParameters a, in CaseParameters b) => a.Resolution == b.Resolution && a.SupportRatio.Equals(b.SupportRatio) &&
            a.TimeStepFraction.Equals(b.TimeStepFraction) && a.SoundSpeedRatio.Equals(b.SoundSpeedRatio);

        static IEnumerable<ChartRun> Seeded(IEnumerable<ChartConfig> configs, int first, int last)
        {
            List<ChartConfig> list = configs.ToList();
            for (int seed = first; seed <= last; seed++)
            {
                foreach (ChartConfig config in list)
                    yield return new ChartRun(config, seed);
            }
        }
    }
}
