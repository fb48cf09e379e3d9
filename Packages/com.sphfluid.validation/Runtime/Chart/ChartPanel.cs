using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A panel of the chart: one error of one case.</summary>
    public sealed class ChartPanel
    {
        private readonly Dictionary<string, ChartConfig> bases;

        private ChartPanel(ValidationCase validationCase, string errorName, IReadOnlyList<ChartPoint> points,
            Dictionary<string, ChartConfig> bases)
        {
            Case = validationCase;
            ErrorName = errorName;
            Points = points;
            this.bases = bases;
        }

        /// <summary>The case.</summary>
        public ValidationCase Case { get; }

        /// <summary>Name of the error.</summary>
        public string ErrorName { get; }

        /// <summary>All points of it, of known methods.</summary>
        public IReadOnlyList<ChartPoint> Points { get; }

        /// <summary>Whether the error is a fraction: its name ends with no unit in brackets.</summary>
        public bool IsFraction => !ErrorName.EndsWith("]", StringComparison.Ordinal);

        /// <summary>The panels of a case: one for its main error, and one beside it for its companion.</summary>
        /// <param name="validationCase">The case.</param>
        /// <param name="rows">Lines of the table.</param>
        public static IReadOnlyList<ChartPanel> Of(ValidationCase validationCase, IReadOnlyList<ChartRow> rows)
        {
            var bases = new Dictionary<string, ChartConfig>();
            foreach (CaseMethod method in CaseMethod.All)
            {
                bases.Add(method.Name, new ChartConfig(validationCase, validationCase.Base(method), ChartFactor.Base));
            }
            return new[] { validationCase.ErrorName, validationCase.CompanionErrorName }
                .Where(name => name != null)
                .Select(name => new ChartPanel(validationCase, name,
                    ChartPoint.Of(rows, validationCase.Name, name).Where(p => bases.ContainsKey(p.Method)).ToList(), bases))
                .Where(panel => panel.Points.Count > 0)
                .ToList();
        }

        /// <summary>What a point differs in from its method's base.</summary>
        public ChartFactor FactorOf(ChartPoint point) => point.FactorFrom(bases[point.Method]);

        /// <summary>A method's points of a factor with the base among them, in the order of the factor's values.</summary>
        /// <param name="method">The method.</param>
        /// <param name="factor">The factor.</param>
        public IReadOnlyList<ChartPoint> Sweep(CaseMethod method, ChartFactor factor)
        {
            List<ChartPoint> points = Points.Where(p => p.Method == method.Name && p.Error.HasValue && p.Cost.HasValue).ToList();
            List<ChartPoint> sweep = points.Where(p => FactorOf(p) == factor).ToList();
            if (sweep.Count > 0) sweep.AddRange(points.Where(p => FactorOf(p) == ChartFactor.Base));
            return sweep.OrderBy(p => ValueOf(p, factor)).ToList();
        }

        private static double ValueOf(ChartPoint point, ChartFactor factor)
        {
            switch (factor)
            {
                case ChartFactor.Spacing: return point.Spacing;
                case ChartFactor.Support: return point.SupportRatio;
                case ChartFactor.TimeStep: return point.TimeStepFraction;
                default: return point.SoundSpeedRatio;
            }
        }
    }
}
