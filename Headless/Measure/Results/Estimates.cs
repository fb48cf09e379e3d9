using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Measure.Results;

/// <summary>The steps of <c>./run model</c>: what they would take on cards that are not at hand.</summary>
internal static partial class Estimates
{
    /// <param name="Config">The row of solver.csv that the step is.</param>
    /// <param name="Microseconds">At each of <see cref="Sizes"/>, the middle of the range that the model gives.</param>
    internal sealed record Step(string Name, string Config, string Gpu, double[] Microseconds);

    public static readonly int[] Sizes = [65536, 262144, 1048576];

    // Steps that follow each other in a frame order their particles anew every third time; the model's nearest mean is that of four.
    private static readonly Dictionary<(string Step, string Kappa), string> configs = new()
    {
        [("Standard rebuilt", "2")] = "standard", [("Standard mean of 4", "2")] = "standard_at_once", [("Thesis 27 cells", "2")] = "thesis_27",
        [("Thesis fused sort", "2")] = "thesis_27_fused", [("Standard rebuilt", "2.25")] = "standard_2.25",
        [("Standard mean of 4", "2.25")] = "standard_2.25_at_once",
    };

    /// <summary>Those that solver.csv has rows for; none where there is no file.</summary>
    public static IReadOnlyList<Step> Read(string file) =>
        File.Exists(file)
            ? [.. File.ReadLines(file).SkipWhile(line => !line.StartsWith("step, us", StringComparison.Ordinal)).Skip(1).TakeWhile(line => line.Length > 0)
                .SelectMany(Line)]
            : [];

    private static IEnumerable<Step> Line(string line)
    {
        // Names have spaces, columns two or more.
        string[] cells = Columns().Split(line.Trim());
        if (cells.Length != 3 + Sizes.Length || !configs.TryGetValue((cells[0], cells[1]), out string? config)) yield break;
        yield return new Step(cells[0], config, cells[2], [.. cells[3..].Select(Middle)]);
    }

    // Worked example: of "56 to 110 (chain)" the root of 56 times 110.
    private static double Middle(string range)
    {
        string[] words = range.Split(' ');
        return Math.Sqrt(double.Parse(words[0], CultureInfo.InvariantCulture) * double.Parse(words[2], CultureInfo.InvariantCulture));
    }

    [GeneratedRegex(" {2,}")]
    private static partial Regex Columns();
}
