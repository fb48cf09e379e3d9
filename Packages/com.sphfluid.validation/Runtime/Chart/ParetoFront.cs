using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The points of a case that no other one beats in both time and error.</summary>
    public static class ParetoFront
    {
        /// <summary>The file: the points of all fronts, case by case.</summary>
        public static readonly TableFormat<ChartPoint> Format = new TableFormat<ChartPoint>("pareto.csv")
            .Text("case", p => p.Case)
            .Text("method", p => p.Method)
            .Number("dx", p => p.Spacing)
            .Number("kappa", p => p.SupportRatio)
            .Number("dt_fraction", p => p.TimeStepFraction)
            .Number("c_or_iterations", p => p.SoundSpeedRatio)
            .Count("particles", p => p.Particles)
            .Count("seeds", p => p.Seeds)
            .Number("gpu_ms_per_sim_s", p => p.Cost.Value.Median)
            .Number("gpu_half_bar", p => HalfBar(p.Cost.Value))
            .Number("error", p => p.Error.Value.Median)
            .Number("error_half_bar", p => HalfBar(p.Error.Value))
            .Text("error_name", p => p.ErrorName)
            .Text("device", p => p.Device)
            .Text("date", p => p.Date);

        /// <summary>
        /// The points that are not dominated, the cheapest first. q dominates p when its medians of time and error are both no
        /// greater and one of them is less by more than the half-bars of the two together: 100 ± 10 ms/s does not beat 115 ± 10 ms/s
        /// at the same error, but 90 ± 10 ms/s does. Points with a failed run are left out.
        /// </summary>
        public static IReadOnlyList<ChartPoint> Of(IEnumerable<ChartPoint> points)
        {
            List<ChartPoint> whole = points.Where(p => p.IsWhole).ToList();
            return whole.Where(p => !whole.Any(q => q != p && Dominates(q, p))).OrderBy(p => p.Cost.Value.Median).ToList();
        }

        internal static bool Dominates(ChartPoint q, ChartPoint p)
        {
            SampleStatistics costQ = q.Cost.Value, costP = p.Cost.Value, errorQ = q.Error.Value, errorP = p.Error.Value;
            return costQ.Median <= costP.Median && errorQ.Median <= errorP.Median && (IsBeyond(costQ, costP) || IsBeyond(errorQ, errorP));
        }

        private static bool IsBeyond(in SampleStatistics less, in SampleStatistics more) =>
            more.Median - less.Median > HalfBar(less) + HalfBar(more);

        private static double HalfBar(in SampleStatistics bar) => 0.5 * (bar.Maximum - bar.Minimum);
    }
}
