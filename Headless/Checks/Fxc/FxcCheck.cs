using Headless.Checks.Shaders;
using Headless.Shaders.Direct3D;

namespace Headless.Checks.Fxc;

/// <summary>Compiles every kernel, keyword variant and shader stage with Microsoft's FXC for its 5.0 profile, without
/// warnings, and holds the result against the limits of Direct3D 11.0.</summary>
internal sealed class FxcCheck(string projectRoot, string packageRoot, string cacheFolder)
{
    private const int MaxUavs = 8, MaxSharedBytes = 32 * 1024, MaxThreads = 1024;

    public CheckReport Run()
    {
        var report = new CheckReport("FXC");
        var jobs = HlslJobs.Read(projectRoot, packageRoot, report.Findings);
        var toolchain = new FxcToolchain(cacheFolder);
        if (toolchain.Prepare() is { } missing) { report.SkippedBecause = missing; return report; }
        Compile(jobs, toolchain, report);
        return report;
    }

    private static void Compile(HlslJobs jobs, FxcToolchain toolchain, CheckReport report)
    {
        var folder = Directory.CreateTempSubdirectory("fxc");
        try
        {
            var results = toolchain.Run(folder.FullName, jobs.Write(folder.FullName, profile => profile));
            var slots = 0;
            foreach (var result in results) slots = Math.Max(slots, Judge(result.Split('\t'), jobs.Jobs, report));
            if (results.Count != jobs.Jobs.Count) report.Findings.Add($"{jobs.Jobs.Count} jobs went in, {results.Count} results came out");
            report.Figures = $"{results.Count} entry points and variants of {jobs.Files} files compiled by d3dcompiler_47, at most {slots} instruction slots";
        }
        finally { folder.Delete(recursive: true); }
    }

    private static int Judge(string[] fields, IReadOnlyList<FxcJob> jobs, CheckReport report)
    {
        var job = jobs[int.Parse(fields[0])];
        var (uavs, shared, threads, slots) = (int.Parse(fields[2]), int.Parse(fields[3]), int.Parse(fields[4]), int.Parse(fields[5]));
        var messages = fields.Length > 6 ? fields[6].Trim() : "";
        if (fields[1] != "ok" || messages.Length > 0) report.Findings.Add($"{job.Name} ({job.Profile}): {messages}");
        if (uavs > MaxUavs) report.Findings.Add($"{job.Name}: {uavs} UAVs, Direct3D 11.0 has {MaxUavs}");
        if (shared > MaxSharedBytes) report.Findings.Add($"{job.Name}: {shared} bytes of groupshared memory, the limit is {MaxSharedBytes}");
        if (threads > MaxThreads) report.Findings.Add($"{job.Name}: {threads} threads a group, the limit is {MaxThreads}");
        return slots;
    }
}
