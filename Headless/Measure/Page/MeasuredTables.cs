using System.Globalization;
using Headless.Measure.Parts;
using Headless.Measure.Results;
using SphFluid.Validation;

namespace Headless.Measure.Page;

/// <summary>The tables of a folder of results.</summary>
internal sealed class MeasuredTables(string folder)
{
    private static readonly string[] played = [PlayParts.Frame.Name, PlayParts.Scene.Name, PlayParts.Whitewater.Name, PlayParts.Million.Name];

    private readonly (string Part, FrameTimes Times)[] frames =
    [
        .. from part in played
           let times = FrameTimes.Read(Path.Combine(folder, part, "timings.csv"))
           where times is not null
           select (part, times),
    ];

    /// <summary>The device that the first table names; null where none does.</summary>
    public string? Device => new[] { TableParts.SolverTable, TableParts.SurfaceTable, TableParts.WaterTable, TableParts.ChartTable }
        .Select(Read).SelectMany(table => table.Rows.Select(row => table.Text(row, "device"))).FirstOrDefault()
        ?? played.Select(part => Path.Combine(folder, part, "summary.json")).Where(File.Exists)
            .Select(file => System.Text.Json.Nodes.JsonNode.Parse(File.ReadAllBytes(file))?["device"]?.ToString()).FirstOrDefault(name => name is not null);

    /// <summary>The line of the device in the list, with its driver.</summary>
    public string? DeviceLine => File.Exists(Path.Combine(folder, "devices.txt"))
        ? File.ReadLines(Path.Combine(folder, "devices.txt")).FirstOrDefault(line => Device is { } name && line.Contains(name)) : null;

    public HtmlTable Parts()
    {
        CsvTable parts = Read(ResultFolder.Parts);
        var table = new HtmlTable("The parts", ("Part", false), ("Ended", false), ("Seconds", true), ("Found", false));
        foreach (string[] row in parts.Rows) table.Add([parts.Text(row, "part"), parts.Text(row, "ending"), parts.Text(row, "seconds"), parts.Text(row, "found")]);
        return table;
    }

    public HtmlTable Frames()
    {
        var table = new HtmlTable("A frame in milliseconds, means without the first three",
            ("Part", false), ("Particles", true), ("Frames", true), ("Steps", true), ("GPU", true), ("of it whitewater", true), ("CPU", true), ("The first frame, CPU", true));
        foreach ((string part, FrameTimes times) in frames)
        {
            FrameTimes.Frame[] steady = [.. times.Steady];
            double[] numbers =
            [
                steady[^1].Particles, times.Frames.Count, steady.Average(f => f.Steps), steady.Average(f => f.Gpu), steady.Average(f => f.Whitewater),
                steady.Average(f => f.Cpu), times.Frames[0].Cpu,
            ];
            table.Add([part, .. numbers.Select(ReportWords.Digits)]);
        }
        return table;
    }

    public Plot FramePlot() => new("GPU time of a frame against simulated time", "seconds of the scene", "milliseconds a frame on the GPU", false,
        [.. frames.Select((f, i) => new PlotLine(f.Part, i, false, [.. f.Times.Steady.Select(frame => (frame.Time, frame.Gpu))]))]);

    public HtmlTable Surfaces()
    {
        var table = new HtmlTable("A surface in milliseconds a frame",
            ("Surface", false), ("Method", false), ("Particles", true), ("Cells a side", true), ("Median", true), ("Least", true), ("Most", true), ("Note", false));
        foreach (CsvTable from in new[] { Read(TableParts.SurfaceTable), Read(TableParts.WaterTable) })
            foreach (string[] row in from.Rows)
                table.Add([from.Text(row, "config"), from.Text(row, "surface"), ReportWords.Digits(from.Number(row, "particles")), from.Text(row, "grid"),
                    ReportWords.Digits(from.Number(row, "gpu_ms_median")), ReportWords.Digits(from.Number(row, "gpu_ms_min")),
                    ReportWords.Digits(from.Number(row, "gpu_ms_max")), from.Text(row, "note")]);
        return table;
    }

    public HtmlTable Accuracy()
    {
        CsvTable from = Read(TableParts.ChartTable);
        var table = new HtmlTable("Errors of the chart's cases",
            ("Case", false), ("Method", false), ("dx", true), ("Particles", true), ("Error", true), ("of", false), ("GPU ms a simulated second", true));
        foreach (string[] row in from.Rows)
            table.Add([from.Text(row, "case"), from.Text(row, "method"), from.Text(row, "dx"), ReportWords.Digits(from.Number(row, "particles")),
                from.Number(row, "error").ToString("G4", CultureInfo.InvariantCulture), from.Text(row, "error_name"),
                ReportWords.Digits(from.Number(row, "gpu_ms_per_sim_s"))]);
        return table;
    }

    private CsvTable Read(string name) => CsvTable.Read(Path.Combine(folder, name));
}
