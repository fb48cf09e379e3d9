using Headless.Measure.Parts;
using Headless.Measure.Results;
using SphFluid.Validation;

namespace Headless.Measure.Page;

/// <summary>Steps of solver.csv beside the estimates for them.</summary>
internal sealed class MeasuredSteps
{
    // A colour each; the others are in the table.
    private static readonly string[] drawn = ["thesis_27", "thesis_27_fused", "standard", "standard_at_once", "standard_2.25_at_once", "robust_2.25_at_once"];

    private readonly IReadOnlyList<Estimates.Step> estimates;
    private readonly string device;
    private readonly (string Config, double Particles, double Median, double Least, double Most)[] rows;

    public MeasuredSteps(string folder, IReadOnlyList<Estimates.Step> estimates)
    {
        this.estimates = estimates;
        CsvTable table = CsvTable.Read(Path.Combine(folder, TableParts.SolverTable));
        device = table.Rows.Select(row => table.Text(row, "device")).FirstOrDefault("");
        double Microseconds(string[] row, string column) => 1000 * table.Number(row, column);
        rows =
        [
            .. table.Rows.Select(row => (table.Text(row, "config"), table.Number(row, "particles"), Microseconds(row, "gpu_ms_median"),
                Microseconds(row, "gpu_ms_min"), Microseconds(row, "gpu_ms_max"))),
        ];
    }

    private string[] Gpus => [.. estimates.Select(e => e.Gpu).Distinct()];

    private string[] Configs => [.. rows.Select(r => r.Config).Distinct()];

    public HtmlTable Table()
    {
        var table = new HtmlTable("A step in microseconds",
            [("Method", false), ("Particles", true), ("Median", true), ("Least", true), ("Most", true), .. Gpus.Select(g => ($"Estimate, {g}", true))]);
        foreach (var row in rows.OrderBy(r => Array.IndexOf(Configs, r.Config)).ThenBy(r => r.Particles))
            table.Add([row.Config, ReportWords.Digits(row.Particles), ReportWords.Digits(row.Median), ReportWords.Digits(row.Least), ReportWords.Digits(row.Most),
                .. Gpus.Select(gpu => Estimate(row.Config, gpu, row.Particles))]);
        return table;
    }

    public Plot Plot()
    {
        string[] configs = [.. drawn.Where(Configs.Contains)];
        var lines = configs.Select((config, i) => new PlotLine(config, i, false,
            [.. rows.Where(r => r.Config == config).OrderBy(r => r.Particles).Select(r => (r.Particles, r.Median))])).ToList();
        lines.AddRange(estimates.Where(e => configs.Contains(e.Config) && device.Contains(e.Gpu, StringComparison.Ordinal)).Select(e => new PlotLine($"{e.Name}, estimate for {e.Gpu}",
            Array.IndexOf(configs, e.Config), true, [.. Estimates.Sizes.Select((size, i) => ((double)size, e.Microseconds[i]))])));
        return new Plot("Time of a step against the number of particles", "particles", "microseconds a step", true, lines);
    }

    private string Estimate(string config, string gpu, double particles)
    {
        int size = Array.IndexOf(Estimates.Sizes, (int)particles);
        return size >= 0 && estimates.FirstOrDefault(e => e.Config == config && e.Gpu == gpu) is { } step ? ReportWords.Digits(step.Microseconds[size]) : "";
    }
}
