using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What the report has of a case.</summary>
    internal sealed class ReportCase
    {
        private readonly IReadOnlyList<ChartPoint> comparable;

        /// <param name="group">Its panels, the main error's first.</param>
        /// <param name="comparisons">Methods against each other at equal time, by the main error.</param>
        /// <param name="curves">Its curves.</param>
        public ReportCase(IReadOnlyList<ChartPanel> group, IReadOnlyList<EqualCost.Comparison> comparisons, CaseCurves curves)
        {
            Panels = group.Select(p => new ReportPanel(p)).ToList();
            comparable = EqualCost.Comparable(group[0].Points, group[0].Case.Floor);
            Comparisons = comparisons;
            Curves = curves;
        }

        /// <summary>The case.</summary>
        public ValidationCase Case => Main.Case;

        /// <summary>Its panels, the main error's first.</summary>
        public IReadOnlyList<ReportPanel> Panels { get; }

        /// <summary>The points of the main error.</summary>
        public ChartPanel Main => Panels[0].Panel;

        /// <summary>Methods against each other at equal time.</summary>
        public IReadOnlyList<EqualCost.Comparison> Comparisons { get; }

        /// <summary>Its curves.</summary>
        public CaseCurves Curves { get; }

        /// <summary>The methods that have points, the best last.</summary>
        public IEnumerable<CaseMethod> Methods => CaseMethod.All.Where(m => Main.Points.Any(p => p.Method == m.Name));

        /// <summary>
        /// Points of a method whose every run has an error and a time, without those that are good by chance: see <see cref="EqualCost"/>.
        /// </summary>
        public IEnumerable<ChartPoint> Comparable(CaseMethod method) => comparable.Where(p => p.Method == method.Name);
    }
}
