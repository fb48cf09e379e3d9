using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What a case's points say, in sentences.</summary>
    internal static class ReportSummary
    {
        // Of a 60 Hz frame [ms].
        private const double Budget = 4.0;

        /// <summary>The sentences of a case; none where no point has an error and a time.</summary>
        public static IEnumerable<string> Of(ReportCase reported)
        {
            double level = Level(reported);
            if (double.IsNaN(level))
            {
                yield return "No point has this error and a time in all of its runs. A table of an older version may have it under " +
                    "another name: measure it again.";
                yield break;
            }
            bool fraction = reported.Main.IsFraction;
            yield return $"An error of {ReportWords.Error(level, fraction)}: " + Each(reported, m => Reaches(reported, m, level));
            yield return $"The least error in {Budget:0} ms of a 60 Hz frame: " +
                Each(reported, m => Within(reported, m, Budget * ReportWords.FramesPerSecond));
            foreach (string line in AtEqualTime(reported)) yield return line;
            double floor = reported.Case.Floor;
            if (floor > 0.0)
            {
                yield return $"The reference itself is good for {ReportWords.Error(floor, fraction)} ({reported.Case.FloorSource}): " +
                    "methods below that are equal.";
            }
        }

        /// <summary>
        /// The error that the methods are asked for: the least of 1, 2, 5, 10, ... that one of them reaches and that is not below the
        /// reference's floor. Not a number where nothing can be compared.
        /// </summary>
        public static double Level(ReportCase reported)
        {
            List<double> errors = reported.Methods.SelectMany(reported.Comparable).Select(p => p.Error.Value.Median).ToList();
            if (errors.Count == 0) return double.NaN;
            double least = Math.Max(errors.Min(), reported.Case.Floor);
            double unit = Math.Pow(10.0, Math.Floor(Math.Log10(Math.Max(least, 1e-7))));
            return new[] { 1.0, 2.0, 5.0, 10.0 }.Select(step => step * unit).First(l => l >= least * (1.0 - 1e-9));
        }

        /// <summary>The least GPU time at which a method has an error; null where it never has.</summary>
        public static ChartPoint Cheapest(ReportCase reported, CaseMethod method, double level) =>
            reported.Comparable(method).Where(p => p.Error.Value.Median <= level).OrderBy(p => p.Cost.Value.Median).FirstOrDefault();

        /// <summary>The point of a method with the least error; null where it has none.</summary>
        public static ChartPoint Best(ReportCase reported, CaseMethod method) =>
            reported.Comparable(method).OrderBy(p => p.Error.Value.Median).FirstOrDefault();

        private static string Each(ReportCase reported, Func<CaseMethod, string> say) =>
            string.Join("; ", reported.Methods.Reverse().Select(m => $"{m.Title} {say(m)}")) + ".";

        private static string Reaches(ReportCase reported, CaseMethod method, double level)
        {
            ChartPoint cheapest = Cheapest(reported, method, level), best = Best(reported, method);
            if (cheapest != null)
            {
                double cost = cheapest.Cost.Value.Median;
                return $"from {ReportWords.Milliseconds(cost)} ms of GPU time per simulated second ({ReportWords.PerFrame(cost)} ms a " +
                    "frame)";
            }
            return best == null ? "never, a run of each point failed"
                : $"never, {ReportWords.Error(best.Error.Value.Median, reported.Main.IsFraction)} at best";
        }

        private static string Within(ReportCase reported, CaseMethod method, double cost)
        {
            ChartPoint best = reported.Comparable(method).Where(p => p.Cost.Value.Median <= cost).OrderBy(p => p.Error.Value.Median)
                .FirstOrDefault();
            return best == null ? "no point that cheap" : ReportWords.Error(best.Error.Value.Median, reported.Main.IsFraction);
        }

        private static IEnumerable<string> AtEqualTime(ReportCase reported)
        {
            foreach (EqualCostRange range in EqualCostRange.Of(reported.Comparisons).Reverse())
            {
                yield return range.Ratios == "1"
                    ? $"At equal GPU time the errors of {range.Method.Title} and {range.Other.Title} are equal."
                    : $"At equal GPU time the error of {range.Method.Title} is {range.Ratios} times that of {range.Other.Title}.";
            }
        }
    }
}
