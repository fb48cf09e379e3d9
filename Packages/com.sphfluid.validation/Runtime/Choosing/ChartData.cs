using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A chart that was measured on one device, read from its folder, with the cost of a step by method.</summary>
    public sealed class ChartData
    {
        private readonly Dictionary<string, StepCostModel> costs = new Dictionary<string, StepCostModel>(); // by the name of a method
        private readonly IReadOnlyList<StepCostRow> stepCosts;

        /// <summary>A chart.</summary>
        /// <param name="folder">Where it was read.</param>
        /// <param name="rows">Lines of accuracy.csv.</param>
        /// <param name="stepCosts">Lines of step-costs.csv; none: the costs are fitted to the cases' own times.</param>
        public ChartData(string folder, IReadOnlyList<ChartRow> rows, IReadOnlyList<StepCostRow> stepCosts)
        {
            Folder = folder;
            Rows = rows;
            this.stepCosts = stepCosts;
            foreach (CaseMethod method in CaseMethod.All)
            {
                List<(int, double, double)> samples = stepCosts.Where(r => r.Method == method.Name && r.Milliseconds > 0.0)
                    .Select(r => (r.Particles, r.SupportRatio, r.Milliseconds)).ToList();
                if (samples.Count == 0) samples = OfCases(method).ToList();
                if (samples.Count > 0) costs.Add(method.Name, StepCostModel.Fit(method.Kind, samples));
            }
        }

        /// <summary>Where it was read.</summary>
        public string Folder { get; }

        /// <summary>Lines of accuracy.csv.</summary>
        public IReadOnlyList<ChartRow> Rows { get; }

        /// <summary>The device.</summary>
        public string Device => Rows[0].Device;

        /// <summary>Day of the last run.</summary>
        public string Date => Rows.Max(r => r.Date);

        /// <summary>The same chart with more runs.</summary>
        internal ChartData With(IEnumerable<ChartRow> more) => new ChartData(Folder, Rows.Concat(more).ToList(), stepCosts);

        /// <summary>The cost of a method's step; null where nothing was timed.</summary>
        public StepCostModel CostOf(CaseMethod method) => costs.TryGetValue(method.Name, out StepCostModel cost) ? cost : null;

        /// <summary>Reads a chart.</summary>
        /// <param name="folder">A folder that <c>./run chart</c> wrote.</param>
        /// <exception cref="CommandLineException">There is no chart, or its files cannot be read.</exception>
        public static ChartData Read(string folder)
        {
            string file = Path.Combine(folder, ChartRow.Format.FileName), costFile = Path.Combine(folder, StepCostRow.Format.FileName);
            if (!File.Exists(file))
            {
                throw new CommandLineException(
                    $"--chart: there is no {ChartRow.Format.FileName} in '{CommandLineWords.Shown(folder)}'. Name a folder that ./run " +
                    "chart wrote.");
            }
            try
            {
                List<ChartRow> rows = ChartRow.Format.ReadAll(file, () => new ChartRow());
                if (rows.Count == 0) throw new CommandLineException($"--chart: '{file}' has no runs yet.");
                return new ChartData(folder, rows, File.Exists(costFile) ? StepCostRow.Format.ReadAll(costFile, () => new StepCostRow())
                    : new List<StepCostRow>());
            }
            catch (Exception exception) when (exception is FormatException || exception is IOException ||
                exception is UnauthorizedAccessException)
            {
                throw new CommandLineException($"--chart: {exception.Message}.");
            }
        }

        /// <summary>The newest chart of a device that has a case, among the folders in which charts are kept.</summary>
        /// <param name="project">Folder of the project.</param>
        /// <param name="device">The device.</param>
        /// <param name="caseName">Name of the case; null for any.</param>
        /// <exception cref="CommandLineException">There is none.</exception>
        public static ChartData Newest(string project, string device, string caseName)
        {
            string kept = Path.Combine(project, "benchmarks", "accuracy");
            IEnumerable<string> folders = Directory.Exists(kept) ? Directory.GetDirectories(kept) : Array.Empty<string>();
            List<ChartData> charts = folders.Append(Path.Combine(project, "Build", "chart"))
                .Where(f => File.Exists(Path.Combine(f, ChartRow.Format.FileName)))
                .Select(Read).Where(c => c.Device == device).ToList();
            ChartData newest = charts.Where(c => c.Rows.Any(r => caseName == null || r.Case == caseName))
                .OrderByDescending(c => c.Date, StringComparer.Ordinal)
                .ThenByDescending(c => c.Rows.Count(r => caseName == null || r.Case == caseName)).FirstOrDefault();
            if (newest != null) return newest;
            string made =
                $"Measure one: {(caseName == null ? "" : $"./run chart --case {caseName}, or ")}./run chart --quick for all cases in ten " +
                "minutes; or name another device's with --chart.";
            throw new CommandLineException(charts.Count == 0
                ? $"There is no chart of {device}. {made}"
                : $"No chart of {device} has the case {caseName}. {made}");
        }

        private IEnumerable<(int, double, double)> OfCases(CaseMethod method) =>
            from validationCase in CaseCatalogue.All
            where !validationCase.IsGate
            from point in ChoicePoint.Of(Rows.Where(r => r.Method == method.Name), validationCase)
            where !point.Failed
            from time in point.StepMilliseconds
            where time > 0.0
            select (point.First.Particles, point.First.SupportRatio, time);
    }
}
