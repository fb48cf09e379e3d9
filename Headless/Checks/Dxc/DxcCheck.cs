using Headless.Checks.Shaders;
using Headless.Shaders.Direct3D;

namespace Headless.Checks.Dxc;

/// <summary>Compiles every kernel, keyword variant and shader stage with Microsoft's DXC for shader model 6.0, as HLSL 2018, which
/// Unity takes for "#pragma use_dxc" and for consoles, without warnings.</summary>
internal sealed class DxcCheck(ProjectPackages packages, string cacheFolder)
{
    public CheckReport Run()
    {
        var report = new CheckReport("DXC");
        var toolchain = new WineToolchain(WineDriver.Dxc, cacheFolder);
        if (toolchain.Prepare() is { } missing) { report.SkippedBecause = missing; return report; }
        var jobs = HlslJobs.Read(packages, report.Findings);
        var folder = Directory.CreateTempSubdirectory("dxc");
        try
        {
            var results = toolchain.Run(folder.FullName, jobs.Write(folder.FullName, profile => profile.Replace("_5_0", "_6_0"), _ => false));
            report.Findings.AddRange(results.Select(r => r.Split('\t'))
                .Where(fields => fields[1] != "ok" || Messages(fields).Length > 0)
                .Select(fields => $"{jobs.Jobs[int.Parse(fields[0])].Name}: {Messages(fields)}"));
            if (results.Count != jobs.Jobs.Count) report.Findings.Add($"{jobs.Jobs.Count} jobs went in, {results.Count} results came out");
            report.Figures = $"{results.Count} entry points and variants of {jobs.Files} files compiled by dxcompiler for shader model 6.0, "
                + $"{results.Sum(r => long.Parse(r.Split('\t')[2])) >> 10} KiB of DXIL";
        }
        finally { folder.Delete(recursive: true); }
        return report;
    }

    private static string Messages(string[] fields) => fields.Length > 3 ? fields[3].Trim() : "";
}
