using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Measure.Results;

/// <summary>The last table of <c>./run model</c>: what steps would take on cards that are not at hand.</summary>
internal static partial class Estimates
{
    /// <param name="Config">The row of solver.csv that the step is.</param>
    /// <param name="Microseconds">At each of <see cref="Sizes"/>.</param>
    internal sealed record Step(string Name, string Config, string Gpu, double[] Microseconds);

    public static readonly int[] Sizes = [65536, 1048576];

    // Steps that follow each other in a frame order their particles anew every third time; the model's nearest mean is that of four.
    private static readonly Dictionary<string, string> configs = new()
    {
        ["Standard rebuilt"] = "standard", ["Standard mean of 4"] = "standard_at_once", ["Thesis 27 cells"] = "thesis_27",
        ["Thesis fused sort"] = "thesis_27_fused",
    };

    /// <summary>Those that solver.csv has rows for; none where there is no file.</summary>
    public static IReadOnlyList<Step> Read(string file) =>
        File.Exists(file) ? [.. File.ReadLines(file).SkipWhile(line => !line.StartsWith("step ", StringComparison.Ordinal)).Skip(1).SelectMany(Line)] : [];

    private static IEnumerable<Step> Line(string line)
    {
        // Names have spaces, columns two or more.
        string[] cells = Columns().Split(line.Trim());
        if (cells.Length < 5 || !configs.TryGetValue(cells[0], out string? config)) yield break;
        yield return new Step(cells[0], config, cells[1], [.. cells[^2..].Select(c => double.Parse(c, CultureInfo.InvariantCulture))]);
    }

    [GeneratedRegex(" {2,}")]
    private static partial Regex Columns();
}
