namespace Headless.Checks.Documents;

/// <summary>
/// Each file below benchmarks is named by a document, and all together are small. What is drawn from tables (benchmarks/.gitignore) does not
/// count.
/// </summary>
internal sealed class BenchmarkTableCheck(ProjectPackages packages)
{
    /// <summary>Bytes of all files.</summary>
    public const long Most = 5_000_000;

    private static readonly string[] kinds = [".csv", ".md", ".py"];

    public CheckReport Run()
    {
        var report = new CheckReport("tables of benchmarks");
        var folder = Path.Combine(packages.Project, "benchmarks");
        var files = Directory.Exists(folder) ? Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Where(IsKept).Order().ToList() : [];
        var documents = MarkdownFile.FindAll(packages).Select(d => d.Text).ToList();
        foreach (var path in files.Where(f => Path.GetExtension(f) != ".md").Select(f => Path.GetRelativePath(folder, f).Replace('\\', '/')))
            if (!NamesOf(path).Any(name => documents.Any(d => d.Contains(name, StringComparison.Ordinal))))
                report.Findings.Add($"benchmarks/{path}: no document names it or its folder");
        var bytes = files.Sum(f => new FileInfo(f).Length);
        if (bytes > Most) report.Findings.Add($"benchmarks has {bytes / 1e6:0.0} MB, at most {Most / 1e6:0.0}: what a newer table replaced, and no page quotes, is in the history");
        report.Figures = $"{files.Count} files, {bytes / 1e6:0.0} MB";
        return report;
    }

    private static bool IsKept(string file) => kinds.Contains(Path.GetExtension(file)) && Path.GetFileName(Path.GetDirectoryName(file)) != "curves";

    /// <summary>accuracy/llvmpipe-2026-11-25/pareto.csv: itself or its folder. model/waves.csv: itself or `waves.csv`, as a folder of one purpose holds nearly anything.</summary>
    private static string[] NamesOf(string path)
    {
        var folder = Path.GetDirectoryName(path)!.Replace('\\', '/');
        return folder.Contains('/') ? [path, folder] : [path, $"`{Path.GetFileName(path)}`"];
    }
}
