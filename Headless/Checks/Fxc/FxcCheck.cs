using Headless.Checks.Shaders;
using Headless.Shaders.Direct3D;

namespace Headless.Checks.Fxc;

/// <summary>Compiles every kernel, keyword variant and shader stage with Microsoft's FXC for its 5.0 profile, without
/// warnings, and holds the result against the limits of Direct3D 11.0.</summary>
internal sealed class FxcCheck(ProjectPackages packages, string cacheFolder)
{
    private const int MaxUavs = 8, MaxThreads = 1024;

    public CheckReport Run()
    {
        var report = new CheckReport("FXC");
        var jobs = HlslJobs.Read(packages, report.Findings);
        var toolchain = new WineToolchain(WineDriver.Fxc, cacheFolder);
        if (toolchain.Prepare() is { } missing) { report.SkippedBecause = missing; return report; }
        Compile(jobs, toolchain, report);
        return report;
    }

    private void Compile(HlslJobs jobs, WineToolchain toolchain, CheckReport report)
    {
        var folder = Directory.CreateTempSubdirectory("fxc");
        try
        {
            var (results, yardstick) = Measure(jobs, toolchain, folder.FullName, report);
            // A busy moment only lengthens a compilation, and Wine may crash in one: what seems too long, or crashed, is compiled again.
            for (var turn = 0; turn < 3 && results.Where(r => r.HasCrashed || FxcBudget.IsSlow(r)).Select(r => r.Job).ToList() is { Count: > 0 } odd; turn++)
                foreach (var again in Measure(jobs with { Jobs = odd }, toolchain, folder.FullName, report).Results)
                    if (results.FindIndex(r => r.Job == again.Job) is var at && again.IsBetterThan(results[at])) results[at] = again;
            foreach (var result in results) Check(result, report);
            if (results.Count != jobs.Jobs.Count) report.Findings.Add($"{jobs.Jobs.Count} jobs went in, {results.Count} results came out");
            var slots = results.Count > 0 ? results.Max(r => r.Slots) : 0;
            report.Figures = $"{results.Count} entry points and variants of {jobs.Files} files compiled by d3dcompiler_47, at most {slots} instruction slots";
            new FxcBudget(packages.Product).Check(results, report);
            report.Figures += $"; the yardstick took {yardstick:F0} ms";
            new ShaderGroupCheck(packages.Product).Check(results, report);
        }
        finally { folder.Delete(recursive: true); }
    }

    // Times are scaled by the yardstick's.
    private static (List<FxcResult> Results, double Yardstick) Measure(HlslJobs jobs, WineToolchain toolchain, string folder, CheckReport report)
    {
        var all = jobs with { Jobs = [.. jobs.Jobs, FxcYardstick.Job] };
        var lines = all.Write(folder, profile => profile);
        var compiled = toolchain.Run(folder, FxcYardstick.Among(lines.SkipLast(1), lines[^1])).Select(line => FxcResult.Parse(line, all.Jobs)).ToList();
        if (!compiled.Exists(r => r.Job == FxcYardstick.Job && r.Ok) && compiled.Find(r => r.Job == FxcYardstick.Job) is { } lost) report.Findings.Add($"{lost.Job.Name} does not compile: {lost.Messages}");
        return (FxcYardstick.Scale(compiled), FxcYardstick.Milliseconds(compiled));
    }

    private static void Check(FxcResult result, CheckReport report)
    {
        var name = result.Job.Name;
        if (!result.Ok || result.Messages.Length > 0) report.Findings.Add($"{name} ({result.Job.Profile}): {result.Messages}");
        if (result.Uavs > MaxUavs) report.Findings.Add($"{name}: {result.Uavs} UAVs, Direct3D 11.0 has {MaxUavs}");
        if (result.Threads > MaxThreads) report.Findings.Add($"{name}: {result.Threads} threads a group, the limit is {MaxThreads}");
    }
}
