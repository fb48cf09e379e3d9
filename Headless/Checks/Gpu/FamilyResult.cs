using System.Text.RegularExpressions;

namespace Headless.Checks.Gpu;

/// <summary>What the child process of one family printed.</summary>
internal sealed partial class FamilyResult
{
    // 128 + SIGABRT: how a shell and .NET report it. Mesa aborts where it does not know the family's name.
    private const int Aborted = 134;

    private FamilyResult(GpuFamily family) => Family = family;

    public GpuFamily Family { get; }

    /// <summary>"22.3.6", or "" where the child did not say.</summary>
    public string MesaVersion { get; private set; } = "";

    /// <summary>Rows as <see cref="CompiledTables"/> prints them.</summary>
    public List<string> Programs { get; } = [];
    public List<string> Loops { get; } = [];

    /// <summary>Variants that did not compile.</summary>
    public List<string> Problems { get; } = [];
    public int Variants { get; private set; }

    /// <summary>Why there is nothing to hold against the table; null where there is.</summary>
    public string? SkippedBecause { get; private set; }

    public static FamilyResult Read(GpuFamily family, IEnumerable<string> lines, int exitCode, string errors)
    {
        var result = new FamilyResult(family);
        var (current, ended) = ("", false);
        foreach (var line in lines)
        {
            if (After(line, FamilyCompiler.Driver) is { } driver) result.MesaVersion = Mesa().Match(driver).Groups[1].Value;
            else if (After(line, FamilyCompiler.Begin) is { } variant) (current, result.Variants) = (variant, result.Variants + 1);
            else if (After(line, FamilyCompiler.Program) is { } program) result.Programs.Add(program);
            else if (After(line, FamilyCompiler.Loop) is { } loop) result.Loops.Add(loop);
            else if (After(line, FamilyCompiler.Problem) is { } problem) result.Problems.Add(problem);
            else if (line == FamilyCompiler.End) ended = true;
        }
        if (exitCode == FamilyCompiler.NoDriver) result.SkippedBecause = errors;
        else if (exitCode == Aborted && current.Length == 0) result.SkippedBecause = $"Mesa's RADV does not know the family {family.Name}";
        else if (!ended) result.Problems.Add($"RADV's compiler ended with exit code {exitCode} at {(current.Length > 0 ? current : "its start")}: {errors}");
        return result;
    }

    /// <summary>Reports hot loops that are in no kernel: renamed, or without a loop that loads from buffers.</summary>
    public void RequireHotLoops() => Problems.AddRange(
        from hot in HotLoop.All
        where !Loops.Exists(line => line.Split(',')[2] == hot.Kernel)
        select $"no kernel '{hot.Kernel}' with a loop over its {hot.Name}s; HotLoop.cs names the kernels that have one");

    private static string? After(string line, string start) => line.StartsWith(start, StringComparison.Ordinal) ? line[start.Length..] : null;

    [GeneratedRegex(@"Mesa (\d+(?:\.\d+)*)")]
    private static partial Regex Mesa();
}
