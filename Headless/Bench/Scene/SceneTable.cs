using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Bench.Scene;

/// <summary>The rows as scene.csv, the frames as scene-frames.csv, and lines for people.</summary>
internal static partial class SceneTable
{
    public const string FileName = "scene.csv", FramesFileName = "scene-frames.csv";

    public const string Head =
        "table,device,scene,phase,build,commit,particles,frames,steps,rebuilds,dispatches,solver_ms,surface_ms,drawing_ms,cpu_ms,"
        + "against,solver_ratio,solver_ratio_median,solver_ratio_low,solver_ratio_high,"
        + "surface_ratio,surface_ratio_median,surface_ratio_low,surface_ratio_high,drawing_ratio,cpu_ratio,cpu_ratio_median,cpu_ratio_low,cpu_ratio_high,pass_stamps,date,driver,processor";

    /// <summary>Behind these come two columns a pass.</summary>
    public const string FramesHead = "build,phase,frame,steps,dispatches,cpu_ms,";

    public static void Write(SceneOptions options, IReadOnlyList<SceneRow> rows, string against)
    {
        string scene = Path.GetFileNameWithoutExtension(options.Scene), date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
        var lines = new List<string> { Head };
        foreach (SceneRow row in rows)
        {
            bool isThis = row.Player.Build == options.Build;
            string[] cells =
            [
                "scene", row.Player.DeviceName, scene, row.Phase.Name, isThis ? "this" : "against", row.Player.Build.Commit, Text(row.Player.Particles), Text(row.Numbers.Count),
                Text(row.Steps), Text(row.Rebuilds), Text(row.Dispatches), Text(row.Solver), Text(row.Surface), Text(row.Drawing), Text(row.Processor),
                isThis ? against : "", .. Cells(row.SolverRatio), .. Cells(row.SurfaceRatio), Text(row.DrawingRatio.OfSums), .. Cells(row.ProcessorRatio), "1", date,
                row.Player.Driver, row.Player.Processor,
            ];
            lines.Add(string.Join(',', cells.Select(Quoted)));
        }
        Directory.CreateDirectory(options.Out);
        File.WriteAllLines(Path.Combine(options.Out, FileName), lines);
        WriteFrames(options, rows);
    }

    /// <summary>Solver, surface and drawing times of the rows "this" of an earlier table, by phase.</summary>
    public static Dictionary<string, (double Solver, double Surface, double Drawing)> Read(string file)
    {
        string[][] lines = [.. File.ReadLines(file).Select(Cells)];
        if (lines.Length == 0 || !lines[0].Contains("solver_ms")) throw new UsageException($"--against: '{file}' is no table of --table scene.");
        string Cell(string[] line, string name) => line[Array.IndexOf(lines[0], name)];
        double Number(string[] line, string name) => double.Parse(Cell(line, name), CultureInfo.InvariantCulture);
        return lines.Skip(1).Where(line => Cell(line, "build") == "this").ToDictionary(
            line => Cell(line, "phase"), line => (Number(line, "solver_ms"), Number(line, "surface_ms"), Number(line, "drawing_ms")));
    }

    public static void Say(IReadOnlyList<SceneRow> rows, SceneOptions options)
    {
        Console.WriteLine($"{"for a simulated second",-26}{"steps",8}{"rebuilds",10}{"dispatches",12}{"solver ms",12}{"surface ms",12}{"drawing ms",12}{"CPU ms",10}   ratio of the solver; of CPU time (quarters of the pairs)");
        foreach (SceneRow row in rows)
        {
            string name = $"{row.Phase.Name} {(row.Player.Build == options.Build ? "this" : "against")} {row.Player.Build.Commit}";
            string ratio = string.Join("; ", new[] { row.SolverRatio, row.ProcessorRatio }.Where(r => !double.IsNaN(r.OfSums)).Select(Said));
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{name,-26}{row.Steps,8:0}{row.Rebuilds,10:0}{row.Dispatches,12:0}{row.Solver,12:0}{row.Surface,12:0}{row.Drawing,12:0}{row.Processor,10:0}   {ratio}"));
        }
    }

    private static string Said(Ratio ratio) => string.Create(CultureInfo.InvariantCulture,
        $"{ratio.OfSums:0.00}{(double.IsNaN(ratio.Median) ? "" : $", median {ratio.Median:0.00} ({ratio.Low:0.00} to {ratio.High:0.00})")}");

    private static void WriteFrames(SceneOptions options, IReadOnlyList<SceneRow> rows)
    {
        string[] scopes = [.. rows.SelectMany(r => r.Player.Frames.Values).SelectMany(f => f.Scopes.Keys).Distinct().Order(StringComparer.Ordinal)];
        var lines = new List<string> { FramesHead + string.Join(',', scopes.SelectMany(s => new[] { "ms." + s, "times." + s })) };
        foreach (SceneRow row in rows)
        {
            foreach (int number in row.Numbers)
            {
                PlayedFrame frame = row.Player.Frames[number];
                IEnumerable<string> cells = scopes.SelectMany(s => frame.Scopes.TryGetValue(s, out var scope) ? new[] { Text(scope.Milliseconds), Text(scope.Times) } : ["", ""]);
                lines.Add($"{(row.Player.Build == options.Build ? "this" : "against")},{row.Phase.Name},{number},{frame.Steps},{frame.Dispatches},{Text(frame.Processor)},{string.Join(',', cells)}");
            }
        }
        File.WriteAllLines(Path.Combine(options.Out, FramesFileName), lines);
    }

    private static string[] Cells(Ratio ratio) => [Text(ratio.OfSums), Text(ratio.Median), Text(ratio.Low), Text(ratio.High)];

    private static string Text(double value) => double.IsFinite(value) ? value.ToString("G6", CultureInfo.InvariantCulture) : "";

    // A comma within quotes is one of its cell; a quote there is written twice.
    private static string[] Cells(string line) =>
        [.. Cell().Matches(line).Select(m => m.Groups["quoted"].Success ? m.Groups["quoted"].Value.Replace("\"\"", "\"") : m.Groups["plain"].Value)];

    [GeneratedRegex("""(?<=^|,)(?:"(?<quoted>(?:[^"]|"")*)"|(?<plain>[^,]*))""")]
    private static partial Regex Cell();

    private static string Quoted(string cell) => cell.AsSpan().IndexOfAny(',', '"') < 0 ? cell : $"\"{cell.Replace("\"", "\"\"")}\"";
}
