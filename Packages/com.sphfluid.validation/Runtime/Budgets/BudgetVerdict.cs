using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Errors of played liquids against the mean motion of the reference's runs, and whether a given way was better at the cost of a chosen
    /// one.
    /// </summary>
    internal static class BudgetVerdict
    {
        /// <summary>Share by which two measured times may differ and count as equal.</summary>
        public const double SameCost = 1.1;

        // Standard deviations of the difference of two means.
        private const double Certain = 2.0;

        /// <summary>
        /// Sets the errors, the costs and the better ways of rows of one number of particles. Runs of one liquid, given or picked, share
        /// their cost: the median of all.
        /// </summary>
        public static void Judge(IReadOnlyList<BudgetRow> rows)
        {
            BudgetRow[] reference = rows.Where(r => r.Way == BudgetWay.Reference).ToArray();
            if (reference.Length == 0) return;
            Vector3[] mean = Enumerable.Range(0, reference[0].Path.Length).Select(i => Mean(reference.Select(r => r.Path[i]))).ToArray();
            foreach (BudgetRow row in rows) row.Error = ErrorOf(row.Path, mean) / row.Spacing;
            foreach (IGrouping<(string, double, int), BudgetRow> equal in rows.GroupBy(Liquid))
            {
                double cost = Median(equal.Select(r => r.Milliseconds));
                foreach (BudgetRow row in equal) row.Cost = cost;
            }
            ILookup<BudgetWay, BudgetRow> byWay = rows.ToLookup(r => r.Way);
            foreach (IGrouping<BudgetWay, BudgetRow> chosen in byWay.Where(w => !double.IsNaN(w.Key.Budget)))
            {
                string better = BudgetWay.Given.Where(way => byWay.Contains(way) &&
                    chosen.Any(c => Liquid(c) != Liquid(byWay[way].First()))).Where(way => IsBetter(byWay[way].ToArray(), chosen.ToArray()))
                    .OrderBy(way => byWay[way].Average(r => r.Error)).Select(way => way.Name).FirstOrDefault() ?? "";
                foreach (BudgetRow row in chosen) row.BetterWay = better;
            }
        }

        /// <summary>Whether runs took no longer than others and their mean error is less by more than the scatter of both.</summary>
        public static bool IsBetter(IReadOnlyList<BudgetRow> given, IReadOnlyList<BudgetRow> chosen)
        {
            if (Median(given.Select(r => r.Cost)) > SameCost * Median(chosen.Select(r => r.Cost))) return false;
            double scatter = Math.Sqrt(Variance(given) / given.Count + Variance(chosen) / chosen.Count);
            return given.Average(r => r.Error) + Certain * scatter < chosen.Average(r => r.Error);
        }

        // Equal for runs that compute the same, however they were asked for.
        private static (string, double, int) Liquid(BudgetRow row) => (row.Method, row.MaxCompression, row.Substeps);

        private static double ErrorOf(Vector3[] path, Vector3[] reference)
        {
            int count = Math.Min(path.Length, reference.Length);
            double sum = 0.0;
            for (int i = 0; i < count; i++) sum += (path[i] - reference[i]).sqrMagnitude;
            return Math.Sqrt(sum / count);
        }

        private static double Variance(IReadOnlyList<BudgetRow> rows)
        {
            if (rows.Count < 2) return 0.0;
            double mean = rows.Average(r => r.Error);
            return rows.Sum(r => (r.Error - mean) * (r.Error - mean)) / (rows.Count - 1);
        }

        private static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.OrderBy(v => v).ToArray();
            return sorted[(sorted.Length - 1) / 2];
        }

        private static Vector3 Mean(IEnumerable<Vector3> places)
        {
            Vector3 sum = Vector3.zero;
            int count = 0;
            foreach (Vector3 place in places)
            {
                sum += place;
                count++;
            }
            return sum / count;
        }
    }
}
