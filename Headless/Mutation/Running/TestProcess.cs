using System.Collections.Concurrent;
using System.Diagnostics;
using System.Text.RegularExpressions;

namespace Headless.Mutation.Running;

/// <summary>How the tests of one mutant ended.</summary>
/// <param name="CaughtBy">Name of the test that failed; null when all passed.</param>
/// <param name="Reason">What it said, or why the player did not come to an end.</param>
internal sealed record TestVerdict(string? CaughtBy, string Reason, int Run);

/// <summary>
/// Runs tests in a player, one after the other until one fails. The player stays: starting it takes longer than most tests.
/// A test that takes far longer than it did when it was recorded is ended with the player, and counts as failed.
/// </summary>
internal sealed partial class TestProcess(string player, ProjectOverlay overlay, string folder, string cache) : IDisposable
{
    // Of processor time: a busy machine makes everything slow, but only a loop without end uses it up.
    private const double StartSeconds = 60.0, LeastSeconds = 30.0, Slower = 8.0;
    private static readonly TimeSpan Silence = TimeSpan.FromMinutes(15);
    private const int MostRuns = 60;
    private Process? process;
    private BlockingCollection<string> lines = [];

    /// <summary>Runs of the player that is there; 0 when the next run starts one.</summary>
    public int Runs { get; private set; }

    public TestVerdict Run(IReadOnlyList<MappedTest> tests)
    {
        string list = Path.Combine(folder, "tests.txt");
        File.WriteAllLines(list, tests.Select(t => t.Name));
        if (Runs >= MostRuns || process is null or { HasExited: true }) Restart();
        if (process is null) Start(list);
        else process.StandardInput.WriteLine(list);
        Runs++;
        return Follow(tests);
    }

    /// <summary>Ends the player, so that the next run begins with another one.</summary>
    public void Restart()
    {
        if (process is not null)
        {
            if (!process.HasExited) process.Kill(entireProcessTree: true);
            process.WaitForExit();
            process.Dispose();
        }
        process = null;
        lines = [];
        Runs = 0;
    }

    public void Dispose() => Restart();

    private TestVerdict Follow(IReadOnlyList<MappedTest> tests)
    {
        Dictionary<string, double> left = tests.ToDictionary(t => t.Name, t => t.Seconds);
        string? failed = null, message = null;
        int run = 0;
        double start = Runs == 1 ? StartSeconds : 0.0;
        while (true)
        {
            double limit = start + LeastSeconds + Slower * left.Values.DefaultIfEmpty(0.0).Max();
            if (Next(limit) is not { Length: > 0 } line)
            {
                string reason = process!.HasExited ? "the player ended" : "time-out";
                Restart();
                return new TestVerdict(failed ?? tests.FirstOrDefault(t => left.ContainsKey(t.Name))?.Name ?? "", message ?? reason, run + 1);
            }
            if (SumLine().IsMatch(line)) break;
            Match match = TestLine().Match(line);
            if (match.Success)
            {
                run++;
                start = 0.0;
                left.Remove(match.Groups[2].Value);
                if (match.Groups[1].Value == "FAIL") failed ??= match.Groups[2].Value;
            }
            else if (failed is not null && message is null) message = line.Trim();
        }
        if (failed is null && run < tests.Count) throw new InvalidOperationException($"{tests.Count - run} of {tests.Count} tests were not run, as {left.Keys.First()}: record the map anew (--map).");
        return new TestVerdict(failed, failed is null ? "" : message ?? "", run);
    }

    // The next line of the player; null or empty when it ended or used more processor time than allowed.
    private string? Next(double seconds)
    {
        var clock = Stopwatch.StartNew();
        TimeSpan used = process!.HasExited ? TimeSpan.Zero : process.TotalProcessorTime;
        string? line;
        while (!lines.TryTake(out line, TimeSpan.FromSeconds(1.0)))
        {
            process.Refresh();
            if (process.HasExited) return lines.TryTake(out line, TimeSpan.FromSeconds(1.0)) ? line : null;
            if ((process.TotalProcessorTime - used).TotalSeconds > seconds || clock.Elapsed > Silence) return null;
        }
        return line;
    }

    private void Start(string list)
    {
        string[] words =
        [
            "-n", "10", player, "test", "--project", overlay.Project, "--assemblies", overlay.Assemblies, "--tests", list, "--stop-on-fail", "--again",
            "--poison", "--check-bounds", // as ./test runs edit mode
        ];
        var start = new ProcessStartInfo("nice", words) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
        // Shaders of changes have no place in the user's cache.
        start.Environment["XDG_CACHE_HOME"] = Path.GetFullPath(cache);
        process = Process.Start(start)!;
        BlockingCollection<string> output = lines;
        process.OutputDataReceived += (_, e) =>
        {
            // The empty line stands for the end of the output.
            if (e.Data is null) output.Add("");
            else if (e.Data.Trim().Length > 0) output.Add(e.Data);
        };
        process.ErrorDataReceived += (_, _) => { };
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
    }

    [GeneratedRegex(@"^  (pass|FAIL|skip|none)  (.*) \(-?\d+ ms\)$")] private static partial Regex TestLine();
    [GeneratedRegex(@"^\d+ passed, \d+ failed, \d+ skipped$")] private static partial Regex SumLine();
}
