using System.Globalization;
using Headless.Measure.Children;
using Headless.Measure.Results;

namespace Headless.Measure.Parts;

/// <summary>The package's own measurements, each size in a process of its own: one that does not fit takes no other with it.</summary>
internal static class TableParts
{
    public const string SolverTable = "solver.csv", SurfaceTable = "surface.csv", WaterTable = "water.csv", ChartTable = "accuracy.csv";

    private static readonly int[] sizes = [16384, 65536, 262144, 1048576, 2097152, 4194304, 8000000], smallSizes = [1024, 2048];

    public static Part Solver { get; } = new("solver", "what does a step take, of every method, up to what fits", 22, 8, run =>
        Ladder(run, run.Pick(sizes, smallSizes), SolverTable, SolverTable, size => ["--table", "solver", "--particles", size]));

    public static Part Surface { get; } = new("surface", "what do the surfaces take", 8, 8, run =>
        Ladder(run, [run.Pick(65536, 1024)], SurfaceTable, SurfaceTable,
            size => ["--table", "surface", "--particles", size, "--grids", run.Pick("64,128,256", "16")]));

    public static Part Water { get; } = new("water", "what do the surface and water of a million particles take", 5, 8, run =>
        Ladder(run, [run.Pick(1048576, 1024)], SurfaceTable, WaterTable, size => ["--table", "surface", "--particles", size, "--grids", "none"]));

    public static Part Chart { get; } = new("chart", "is a case of the chart as accurate as elsewhere", 8, 10, run =>
    {
        string[] methods = run.Pick<string[]>(["standard", "thesis"], ["standard"]);
        ChildResult child = run.Measure("Chart", run.In(), ["--quick", "--case", "hydrostatic", "--method", .. methods]);
        if (File.Exists(run.In(ChartTable))) File.Copy(run.In(ChartTable), run.Results.In(ChartTable), overwrite: true);
        return PartOutcome.Of(child, [$"{CsvTable.Read(run.In(ChartTable)).Rows.Count} rows in {ChartTable}"]);
    });

    /// <summary>Sizes from small to large until one does not end well. Where memory ends, the ladder does, and that is what it was to find.</summary>
    private static PartOutcome Ladder(PartRun run, IReadOnlyList<int> sizes, string table, string joined, Func<string, IReadOnlyList<string>> words)
    {
        var lines = new List<string>();
        var written = new List<string>();
        foreach (int size in sizes)
        {
            string name = size.ToString(CultureInfo.InvariantCulture), to = run.In(name);
            ChildResult child = run.Measure("Bench", to, words(name));
            written.Add(Path.Combine(to, table));
            CsvTable.Join(written, run.Results.In(joined));
            if (child.Ending == ChildEnding.Done) continue;
            lines.Add($"{size:#,0} particles: {ChildResult.Word(child.Ending)}; larger numbers are left out");
            bool foundTheEnd = child.Ending == ChildEnding.OutOfMemory && size != sizes[0];
            return PartOutcome.Of(child with { Ending = foundTheEnd ? ChildEnding.Done : child.Ending }, Rows(run.Results.In(joined)).Concat(lines));
        }
        return new PartOutcome(ChildEnding.Done, [.. Rows(run.Results.In(joined))]);
    }

    private static IEnumerable<string> Rows(string file)
    {
        CsvTable table = CsvTable.Read(file);
        if (table.Rows.Count == 0) yield break;
        string[] counts = [.. table.Rows.Select(row => table.Text(row, "particles")).Distinct()];
        yield return $"{table.Rows.Count} rows in {Path.GetFileName(file)}, with {string.Join(", ", counts)} particles";
    }
}
