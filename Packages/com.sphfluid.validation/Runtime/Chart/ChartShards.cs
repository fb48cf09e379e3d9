using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>How the shards of a chart become the whole.</summary>
    internal static class ChartShards
    {
        /// <summary>Tables, curves, and the session that draws.</summary>
        public static ShardedVerb Verb { get; } = new ShardedVerb("chart",
            new[]
            {
                ShardedTable.Of(ChartRow.Format, new[] { "case", "method", "dx", "kappa", "dt_fraction", "c_or_iterations", "seed" },
                    "gpu_ms_per_sim_s", "cpu_ms_per_sim_s", "gpu_ms_low", "gpu_ms_high", "time_spread"),
                ShardedTable.OfTimes(StepCostRow.Format, "method", "kappa", "particles"),
            },
            words => ChartSession.Files(ChartArguments.Parse(words).Cases),
            CopyCurves,
            (words, device, progress) => ChartSession.OfTables(ChartArguments.Parse(words), device, progress));

        // A chart in one go has the curves of a case's base, or else of the first run that has any.
        private static void CopyCurves(SweepMerge merge, string folder)
        {
            foreach (ValidationCase validationCase in CaseCatalogue.All)
            {
                foreach (CaseMethod method in CaseMethod.All)
                {
                    List<string> having = merge.Shards.Select(s => s.Folder)
                        .Where(f => File.Exists(CurveFile.PathOf(f, validationCase.Name, method.Name))).ToList();
                    if (having.Count == 0) continue;
                    string from = having.Count == 1 ? having[0] : First(having, validationCase, method, merge.Runs);
                    CsvText.WriteWhole(CurveFile.PathOf(folder, validationCase.Name, method.Name),
                        File.ReadAllLines(CurveFile.PathOf(from, validationCase.Name, method.Name)));
                }
            }
        }

        private static string First(IEnumerable<string> folders, ValidationCase validationCase, CaseMethod method,
            IEnumerable<PlannedRun> plan)
        {
            string panel = ShardedTable.RunKey(ChartRow.Format, $"{validationCase.Name}|{method.Name}|");
            List<string> order = plan.Where(r => r.Key.StartsWith(panel, StringComparison.Ordinal))
                .Select(r => Constants(r.Key.Substring(panel.Length)))
                .Prepend(new ChartConfig(validationCase, validationCase.Base(method), ChartFactor.Base).Constants).ToList();
            return folders.OrderBy(folder =>
            {
                int place = order.IndexOf(RunOf(folder, validationCase, method));
                return place < 0 ? order.Count : place;
            }).First();
        }

        // Of the rest of a run's name: dx, κ, dt, c and the seed.
        private static string Constants(string rest)
        {
            double[] numbers = rest.Split('|').Select(CsvText.Number).ToArray();
            return ChartConfig.ConstantsOf(numbers[0], numbers[1], numbers[2], numbers[3]);
        }

        private static string RunOf(string folder, ValidationCase validationCase, CaseMethod method)
        {
            try
            {
                CurveFile.Read(folder, validationCase.Name, method.Name, out string run);
                return run;
            }
            catch (FormatException exception)
            {
                throw new IOException($"'{CurveFile.PathOf(folder, validationCase.Name, method.Name)}' is broken: {exception.Message}",
                    exception);
            }
        }
    }
}
