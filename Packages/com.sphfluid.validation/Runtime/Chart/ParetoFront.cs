using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The points of a case that no other one beats in both time and error.</summary>
    public static class ParetoFront
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "pareto.csv";

        internal static readonly string[] Columns =
        {
            "case", "method", "dx", "kappa", "dt_fraction", "c_or_iterations", "particles", "seeds", "gpu_ms_per_sim_s", "gpu_half_bar",
            "error", "error_half_bar", "error_name", "device", "date",
        };

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

        /// <summary>Lines of the file.</summary>
        /// <param name="fronts">Points of the fronts, case by case.</param>
        public static IEnumerable<string> Lines(IEnumerable<ChartPoint> fronts)
        {
            yield return CsvText.Join(Columns);
            foreach (ChartPoint p in fronts)
            {
                yield return CsvText.Join(new[]
                {
                    p.Case, p.Method, CsvText.Text(p.Spacing), CsvText.Text(p.SupportRatio), CsvText.Text(p.TimeStepFraction),
                    CsvText.Text(p.SoundSpeedRatio), CsvText.Text(p.Particles), CsvText.Text(p.Seeds),
                    CsvText.Text(p.Cost.Value.Median), CsvText.Text(HalfBar(p.Cost.Value)),
                    CsvText.Text(p.Error.Value.Median), CsvText.Text(HalfBar(p.Error.Value)), p.ErrorName, p.Device, p.Date,
                });
            }
        }

        /// <summary>Writes the file whole.</summary>
        /// <param name="folder">Its folder.</param>
        /// <param name="fronts">Points of the fronts, case by case.</param>
        public static void Write(string folder, IEnumerable<ChartPoint> fronts) => CsvText.WriteWhole(Path.Combine(folder, FileName), Lines(fronts));

        static bool IsBeyond(in SampleStatistics less, in SampleStatistics more) => more.Median - less.Median > HalfBar(less) + HalfBar(more);

        static double HalfBar(in SampleStatistics bar) => 0.5 * (bar.Maximum - bar.Minimum);
    }
}
