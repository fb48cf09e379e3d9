using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Checks.Fxc;

/// <summary>Holds the numbers of the package's shader groups, which decide what devices it runs on, against FXC's listings.</summary>
internal sealed partial class ShaderGroupCheck(string packageRoot)
{
    private const string Source = "a shader group of the package";

    private sealed record Needs(string Folder, int GroupThreads, int Buffers, int WritableBuffers, int GroupMemory, int VertexBuffers, string Keyword);

    public void Check(IReadOnlyList<FxcResult> results, CheckReport report)
    {
        var sources = Directory.GetFiles(packageRoot, "*.cs", SearchOption.AllDirectories).Where(f => !f.Contains("/Tests/", StringComparison.Ordinal)).ToList();
        if (!sources.Any(f => Path.GetFileName(f) == "ShaderGroup.cs")) return;
        var stated = sources.SelectMany(f => Stated().Matches(File.ReadAllText(f))).Select(Read).ToList();
        if (stated.Count == 0) { report.Findings.Add("the package has no shader group that this check can read"); return; }
        var parts = results.GroupBy(r => FolderOf(r.Job, stated));
        foreach (var part in parts.Where(p => p.Key is not null))
        {
            var claim = stated.Find(s => s.Folder == part.Key)!;
            var counted = Count(claim, [.. part]);
            if (claim != counted) report.Findings.Add($"{Source} says of {part.Key}: {Show(claim)}; FXC's listings say: {Show(counted)}");
        }
        foreach (var needs in stated.Where(s => parts.All(p => p.Key != s.Folder)))
            report.Findings.Add($"{Source} names {needs.Folder}, which holds no shaders");
    }

    private static Needs Read(Match match)
    {
        int Number(string name) => int.Parse(match.Groups[name].Value, CultureInfo.InvariantCulture);
        return new Needs(match.Groups["folder"].Value, Number("threads"), Number("buffers"), Number("writable"), Number("memory"), Number("vertex"), match.Groups["keyword"].Value);
    }

    private static Needs Count(Needs claim, List<FxcResult> results)
    {
        int Most(bool kernels, Func<FxcResult, int> figure) =>
            results.Where(r => kernels ? r.Job.IsKernel : r.Job.Profile.StartsWith("vs", StringComparison.Ordinal)).Select(figure).DefaultIfEmpty(0).Max();
        return claim with
        {
            GroupThreads = Most(true, r => r.Threads),
            Buffers = Most(true, r => r.Buffers),
            WritableBuffers = Most(true, r => r.Uavs),
            GroupMemory = Most(true, r => r.SharedBytes),
            VertexBuffers = Most(false, r => r.Buffers),
        };
    }

    // That of the keyword, wherever the kernel lies; else the innermost folder that is named.
    private string? FolderOf(FxcJob job, List<Needs> stated)
    {
        if (stated.Find(s => s.Keyword.Length > 0 && job.Keywords.Contains(s.Keyword)) is { } optional) return optional.Folder;
        var path = Path.GetRelativePath(packageRoot, job.File).Replace('\\', '/');
        return stated.Select(s => s.Folder).Where(f => path.StartsWith(f + "/", StringComparison.Ordinal)).MaxBy(f => f.Length);
    }

    private static string Show(Needs needs) =>
        $"{needs.GroupThreads} threads, {needs.Buffers} buffers, {needs.WritableBuffers} written, {needs.GroupMemory} bytes shared, {needs.VertexBuffers} buffers of a vertex shader";

    [GeneratedRegex(@"new ShaderGroup\(""[^""]*"",\s*""(?<folder>[^""]*)"",\s*groupThreads: (?<threads>\d+), buffers: (?<buffers>\d+), writableBuffers: (?<writable>\d+), groupMemory: (?<memory>\d+), vertexBuffers: (?<vertex>\d+)\b(?:[^;]*?\bKeyword = ""(?<keyword>\w+)"")?")]
    private static partial Regex Stated();
}
