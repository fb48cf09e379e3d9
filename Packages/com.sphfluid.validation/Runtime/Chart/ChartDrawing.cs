using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Writes what follows from the table: the Pareto fronts, the comparison at equal time, the report, the scripts, and by gnuplot the
    /// pictures.
    /// </summary>
    internal sealed class ChartDrawing
    {
        private readonly string folder;
        private readonly ResultTable<ChartRow> table;
        private readonly IReadOnlyList<ValidationCase> cases;
        private readonly string command;
        private readonly SessionProgress progress;

        public ChartDrawing(string folder, ResultTable<ChartRow> table, IReadOnlyList<ValidationCase> selected, string command,
            SessionProgress progress)
        {
            this.command = command;
            this.folder = folder;
            this.table = table;
            this.progress = progress;
            // Cases that an earlier chart in the folder measured are drawn too.
            cases = CaseCatalogue.All.Union(selected).Where(c => table.Rows.Any(r => r.Case == c.Name)).ToList();
        }

        public void Write()
        {
            List<IReadOnlyList<ChartPanel>> groups = cases.Select(c => ChartPanel.Of(c, table.Rows)).Where(g => g.Count > 0).ToList();
            if (groups.Count == 0) return;
            List<IReadOnlyList<ChartPoint>> fronts = groups.Select(g => ParetoFront.Of(g[0].Points)).ToList();
            ParetoFront.Format.Write(folder, fronts.SelectMany(f => f));
            SayFronts(groups, fronts);
            List<ReportCase> reported = groups.Select(g =>
                new ReportCase(g, EqualCost.Of(g[0].Points, g[0].Case.Floor), new CaseCurves(g[0].Case, folder))).ToList();
            List<EqualCost.Comparison> comparisons = reported.SelectMany(r => r.Comparisons).ToList();
            EqualCost.Format.Write(folder, comparisons);
            SayComparisons(comparisons);
            string unwritten = new ChartReport(reported, table.Rows, table.Device, command).Write(folder);
            progress.Say(unwritten ?? $"{Path.Combine(folder, ChartReport.FileName)} is written: open it in a browser.");
            var chart = new ChartScript(groups, table.Device, table.Rows.Max(r => r.Date));
            IEnumerable<CurveScript> curves = cases.Select(c => new CurveScript(c, folder)).Where(s => !s.IsEmpty);
            string problem = GnuplotScript.Draw(folder, new GnuplotScript[] { chart }.Concat(curves));
            progress.Say(problem ??
                $"{Path.Combine(folder, "accuracy.png")}, accuracy.svg, {ChartRow.Format.FileName}, {ParetoFront.Format.FileName}, " +
                $"{EqualCost.Format.FileName} and case-*.png are written.");
        }

        // A line for each case and pair of methods: from the least ratio to the greatest, at the times of both methods' points.
        private void SayComparisons(IEnumerable<EqualCost.Comparison> comparisons)
        {
            progress.Say("Error over another method's at equal GPU time, along both fronts:");
            foreach (EqualCostRange range in EqualCostRange.Of(comparisons))
            {
                progress
                    .Say(string.Format(CultureInfo.InvariantCulture, "{0,-18}{1,-32}{2:G3} to {3:G3}", range.Case,
                        $"{range.Method.Name} / {range.Other.Name}",
                    range.Least, range.Greatest));
            }
        }

        private void SayFronts(List<IReadOnlyList<ChartPanel>> groups, List<IReadOnlyList<ChartPoint>> fronts)
        {
            progress.Say($"Points that no other one beats in time and error:");
            progress.Say($"{"case",-18}{"method",-16}{"dx",10}{"kappa",7}{"dt",6}{"c",7}{"particles",11}{"GPU ms/s",12}{"error",10}");
            for (int i = 0; i < groups.Count; i++)
            {
                foreach (ChartPoint p in fronts[i])
                {
                    progress
                        .Say(string.Format(CultureInfo.InvariantCulture,
                            "{0,-18}{1,-16}{2,10:G3}{3,7:G3}{4,6:G3}{5,7:G3}{6,11}{7,12:N0}{8,10:G3}  {9}",
                        p.Case, p.Method, p.Spacing, p.SupportRatio, p.TimeStepFraction, p.SoundSpeedRatio, p.Particles,
                        p.Cost.Value.Median,
                        p.Error.Value.Median, p.ErrorName));
                }
                if (fronts[i].Count == 0) progress.Say($"{groups[i][0].Case.Name,-18}every point has a failed run");
            }
        }
    }
}
