using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The report's tables: what an error costs, the bases, methods at equal time, and all points of a case.</summary>
    internal static class ReportTables
    {
        private const string Never = "never";

        /// <summary>For each case an error, and the GPU time at which each method has it.</summary>
        public static HtmlTable Costs(IReadOnlyList<ReportCase> cases)
        {
            List<CaseMethod> methods = MethodsOf(cases);
            var table = new HtmlTable("GPU ms per simulated second to reach an error; in brackets ms of a 60 Hz frame",
                new[] { ("Case", false), ("Error", false), ("Reach", true) }.Concat(methods.Select(m => (m.Title, true))).ToArray());
            foreach (ReportCase reported in cases)
            {
                double level = ReportSummary.Level(reported);
                table
                    .Add(new[] { reported.Case.Title, reported.Main.ErrorName, double.IsNaN(level) ? "–"
                        : ReportWords.Error(level, reported.Main.IsFraction) }
                    .Concat(methods.Select(m => Cost(reported, m, level))));
            }
            return table;
        }

        /// <summary>The base of each case and method.</summary>
        public static HtmlTable Bases(IReadOnlyList<ReportCase> cases)
        {
            var table = new HtmlTable("The base of each case and method: medians of the seeds", ("Case", false), ("Method", false),
                ("dx [m]", true), ("κ", true),
                ("Particles", true), ("Seeds", true), ("Error", false), ("", true), ("GPU ms/s", true), ("ms a frame", true));
            foreach (ReportCase reported in cases)
            {
                foreach (CaseMethod method in reported.Methods.Reverse())
                {
                    foreach (ChartPoint p in reported.Main.Points.Where(p => p.Method == method.Name &&
                        reported.Main.FactorOf(p) == ChartFactor.Base))
                    {
                        table.Add(new[]
                        {
                            reported.Case.Title, method.Title, ReportWords.Constant(p.Spacing), ReportWords.Constant(p.SupportRatio),
                            ReportWords.Digits(p.Particles),
                            Seeds(p), p.ErrorName, Error(reported, p), Time(p),
                            p.Cost.HasValue ? ReportWords.PerFrame(p.Cost.Value.Median) : "–",
                        });
                    }
                }
            }
            return table;
        }

        /// <summary>Ratios of errors at equal time.</summary>
        public static HtmlTable AtEqualTime(IReadOnlyList<ReportCase> cases)
        {
            var table = new HtmlTable("Error over error at equal GPU time, along both methods' best points; below 1 the first is better",
                ("Case", false), ("Error", false),
                ("Methods", false), ("Ratio", true), ("Times compared", true), ("GPU ms/s", true), ("Against a dearest point", true));
            foreach (ReportCase reported in cases)
            {
                foreach (EqualCostRange range in EqualCostRange.Of(reported.Comparisons))
                {
                    table.Add(new[]
                    {
                        reported.Case.Title, reported.Main.ErrorName, $"{range.Method.Title} / {range.Other.Title}", range.Ratios,
                        CsvText.Text(range.Count),
                        $"{ReportWords.Milliseconds(range.Shortest)} to {ReportWords.Milliseconds(range.Longest)}",
                        CsvText.Text(range.Bounds),
                    });
                }
            }
            return table;
        }

        /// <summary>All points of a case's main error.</summary>
        public static HtmlTable Points(ReportCase reported)
        {
            var table = new HtmlTable($"{reported.Case.Title}: all points", ("Method", false), ("Changed", false), ("dx [m]", true),
                ("κ", true), ("Time step", true), ("c", true),
                ("Particles", true), ("Seeds", true), (reported.Main.ErrorName, true), ("GPU ms/s", true), ("Best points", false),
                ("Failure", false));
            foreach (CaseMethod method in reported.Methods.Reverse())
            {
                foreach (ChartPoint p in reported.Main.Points.Where(p => p.Method == method.Name)
                    .OrderBy(p => p.Cost?.Median ?? double.PositiveInfinity))
                {
                    table.Add(new[]
                    {
                        method.Title, ChartStyle.Title(reported.Main.FactorOf(p)), ReportWords.Constant(p.Spacing),
                        ReportWords.Constant(p.SupportRatio),
                        ReportWords.Constant(p.TimeStepFraction), ReportWords.Constant(p.SoundSpeedRatio),
                        ReportWords.Digits(p.Particles), Seeds(p),
                        Error(reported, p), Time(p), reported.Panels[0].IsOnFront(p) ? "on the front" : "", p.Reason,
                    });
                }
            }
            return table;
        }

        private static List<CaseMethod> MethodsOf(IReadOnlyList<ReportCase> cases) =>
            CaseMethod.All.Where(m => cases.Any(c => c.Methods.Contains(m))).Reverse().ToList();

        private static string Cost(ReportCase reported, CaseMethod method, double level)
        {
            ChartPoint cheapest = ReportSummary.Cheapest(reported, method, level), best = ReportSummary.Best(reported, method);
            if (cheapest != null) return $"{Time(cheapest)} ({ReportWords.PerFrame(cheapest.Cost.Value.Median)})";
            if (!reported.Methods.Contains(method)) return "not measured";
            return best == null ? Never : $"{Never}, {Error(reported, best)} at best";
        }

        private static string Seeds(ChartPoint point) => point.Failures == 0 ? CsvText.Text(point.Seeds)
            : $"{point.Seeds}, {point.Failures} failed";

        private static string Error(ReportCase reported, ChartPoint point) =>
            point.Error.HasValue ? ReportWords.Error(point.Error.Value.Median, reported.Main.IsFraction) : point.Failures > 0
                ? "failed" : "–";

        private static string Time(ChartPoint point) => point.Cost.HasValue ? ReportWords.Milliseconds(point.Cost.Value.Median) : "–";
    }
}
