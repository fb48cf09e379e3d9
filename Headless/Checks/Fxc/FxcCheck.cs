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
        Compile(jobs with { Jobs = [.. jobs.Jobs.Where(job => !WritesSlice(job))] }, toolchain, report);
        return report;
    }

    // Vertex stages that choose a slice of the target, as Unity's own for single-pass stereo do, need Unity's newer compiler; DXC takes them.
    private static bool WritesSlice(FxcJob job) => job.Profile.StartsWith("vs", StringComparison.Ordinal) && job.Keywords.Contains("STEREO_INSTANCING_ON");

    private void Compile(HlslJobs jobs, WineToolchain toolchain, CheckReport report)
    {
        var folder = Directory.CreateTempSubdirectory("fxc");
        try
        {
            var results = Compiled(jobs, toolchain, folder.FullName);
            // Wine may crash in a compilation: that says something of the kernel only where it comes back.
            for (var turn = 0; turn < 3 && results.Where(r => r.HasCrashed).Select(r => r.Job).ToList() is { Count: > 0 } crashed; turn++)
                foreach (var again in Compiled(jobs with { Jobs = crashed }, toolchain, folder.FullName))
                    if (results.FindIndex(r => r.Job == again.Job) is var at && !again.HasCrashed) results[at] = again;
            foreach (var result in results) Check(result, report);
            if (results.Count != jobs.Jobs.Count) report.Findings.Add($"{jobs.Jobs.Count} jobs went in, {results.Count} results came out");
            report.Figures = $"{results.Count} entry points and variants of {jobs.Files} files compiled by d3dcompiler_47";
            new FxcBudget(packages.Product).Check(results, report);
            new ShaderGroupCheck(packages.Product).Check(results, report);
        }
        finally { folder.Delete(recursive: true); }
    }

    // The code of kernels is what "sphplayer test --compiler fxc" runs.
    private static List<FxcResult> Compiled(HlslJobs jobs, WineToolchain toolchain, string folder) =>
        [.. toolchain.Run(folder, jobs.Write(folder, profile => profile, job => job.IsKernel)).Select(line => FxcResult.Parse(line, jobs.Jobs))];

    private static void Check(FxcResult result, CheckReport report)
    {
        var name = result.Job.Name;
        if (!result.Ok || result.Messages.Length > 0) report.Findings.Add($"{name} ({result.Job.Profile}): {result.Messages}");
        if (result.Uavs > MaxUavs) report.Findings.Add($"{name}: {result.Uavs} UAVs, Direct3D 11.0 has {MaxUavs}");
        if (result.Threads > MaxThreads) report.Findings.Add($"{name}: {result.Threads} threads a group, the limit is {MaxThreads}");
    }
}
