using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Measure.Children;
using Headless.Measure.Results;

namespace Headless.Measure.Parts;

/// <summary>The package's tests on the device's driver, by the first letter of their class, several processes at a time.</summary>
internal static partial class TestsPart
{
    private const string SmallTests = @"[.+]ScanCellsTests[.(];[.+]StandardDensityTests[.(];[.+]SampleBlocksTests[.(]";
    private const string Class = @"[.+][A-Z]\w*Tests[.(]", NeedsPython = "!PySphTests";
    private const int Named = 40, FreeProcessors = 2;

    public static Part Part { get; } = new("tests", "do the package's tests pass on this driver", 28, 15, Run) { SmallWeight = 8 };

    /// <summary>
    /// Filters that divide the tests: a class belongs to one of them. They only leave out, since a filter that asks for a test runs it even where it is
    /// marked as explicit, and those take minutes.
    /// </summary>
    internal static IReadOnlyList<(string Name, string Filter)> Shares { get; } =
    [
        .. Enumerable.Range('A', 26).Select(c => ($"{(char)c}", $@"![.+](?!{(char)c})[A-Z]\w*Tests[.(];!^(?!.*{Class});{NeedsPython}")),
        ("others", $"!{Class};{NeedsPython}"),
    ];

    private static PartOutcome Run(PartRun run)
    {
        IReadOnlyList<(string Name, string Filter)> shares = run.Small ? [("small", SmallTests)] : Shares;
        var ended = new TestSum[shares.Count];
        // A software device takes all processors by itself.
        int atOnce = run.Small ? 1 : Math.Max(1, Environment.ProcessorCount - FreeProcessors);
        Parallel.For(0, shares.Count, new ParallelOptions { MaxDegreeOfParallelism = atOnce }, i =>
        {
            string file = run.Results.In(ResultFolder.Logs, "tests", shares[i].Name + ".log");
            using (var log = new ChildLog(file)) ended[i] = new TestSum(shares[i].Name, run.Player("test", ["--filter", shares[i].Filter], log), []);
            ended[i] = ended[i] with { Lines = File.ReadAllLines(file) };
        });
        return Sum(ended);
    }

    internal static PartOutcome Sum(IReadOnlyList<TestSum> shares)
    {
        int passed = shares.Sum(s => s.Count("  pass  ")), skipped = shares.Sum(s => s.Count("  skip  "));
        string[] failures = [.. shares.SelectMany(s => s.Failures)];
        TestSum[] unfinished = [.. shares.Where(s => !s.HasEnded)];
        var lines = new List<string> { $"{passed} passed, {failures.Length} failed, {skipped} skipped" };
        lines.AddRange(failures.Take(Named));
        if (failures.Length > Named) lines.Add($"{failures.Length - Named} more failures are in {ResultFolder.Logs}/tests");
        if (unfinished.Length > 0) lines.Add($"not finished: the classes of {string.Join(", ", unfinished.Select(s => s.Name))}");
        ChildEnding worst = shares.Where(s => !s.HasEnded).Select(s => s.Child.Ending).DefaultIfEmpty(ChildEnding.Done).Max();
        if (unfinished.FirstOrDefault(s => s.Child.Ending > ChildEnding.Stopped) is { } broken)
            lines.AddRange([$"the classes of {broken.Name}:", .. PartOutcome.Why(broken.Child)]);
        return new PartOutcome(failures.Length > 0 ? PartOutcome.Worse(worst, ChildEnding.Failed) : worst, lines);
    }

    /// <summary>What a process of tests said.</summary>
    internal sealed record TestSum(string Name, ChildResult Child, IReadOnlyList<string> Lines)
    {
        /// <summary>Whether its last line is the sum; a letter that begins no class has nothing to do.</summary>
        public bool HasEnded => Lines.Any(line => SumLine().IsMatch(line));

        public IEnumerable<string> Failures => Lines.Where(line => line.StartsWith("  FAIL  ", StringComparison.Ordinal)).Select(line => line.Trim());

        public int Count(string begin) => Lines.Count(line => line.StartsWith(begin, StringComparison.Ordinal));
    }

    [GeneratedRegex(@"^\d+ passed, \d+ failed, \d+ skipped$")]
    private static partial Regex SumLine();
}
