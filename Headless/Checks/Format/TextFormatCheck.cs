namespace Headless.Checks.Format;

/// <summary>
/// Shaders, documents and scripts have no tabs, blanks at line ends or carriage returns, and end with a line break; lines of the packages' shaders
/// have at most max_line_length columns (.editorconfig).
/// </summary>
internal sealed class TextFormatCheck(string project)
{
    private static readonly string[] folders = ["Headless", "Packages", "Assets", "benchmarks"];
    private static readonly string[] shaders = [".hlsl", ".cginc", ".compute", ".shader"];
    private static readonly string[] kinds = [".hlsl", ".cginc", ".compute", ".shader", ".md", ".c", ".h"];

    public CheckReport Run()
    {
        var report = new CheckReport("layout of shaders and documents");
        var files = folders.Select(f => Path.Combine(project, f)).Where(Directory.Exists)
            .SelectMany(f => Directory.EnumerateFiles(f, "*", SearchOption.AllDirectories)).Where(f => kinds.Contains(Path.GetExtension(f))).Order().ToList();
        var columns = EditorConfig.MaxLineLength(project);
        foreach (var file in files)
            report.Findings.AddRange(Faults(File.ReadAllText(file), IsPackagesShader(file) ? columns : int.MaxValue).Select(fault => $"{Path.GetRelativePath(project, file)}: {fault}"));
        report.Figures = $"{files.Count} files";
        return report;
    }

    private bool IsPackagesShader(string file) => shaders.Contains(Path.GetExtension(file)) && Path.GetRelativePath(project, file).StartsWith("Packages", StringComparison.Ordinal);

    private static IEnumerable<string> Faults(string text, int columns)
    {
        var lines = text.Split('\n');
        for (var i = 0; i < lines.Length; i++)
        {
            if (lines[i].Length > columns) yield return $"line {i + 1} has {lines[i].Length} columns";
            if (lines[i].Contains('\t')) yield return $"line {i + 1} has a tab";
            if (lines[i].EndsWith('\r')) yield return $"line {i + 1} ends with a carriage return";
            else if (lines[i].EndsWith(' ')) yield return $"line {i + 1} ends with a blank";
        }
        if (text.Length > 0 && lines[^1].Length > 0) yield return "the last line has no end";
    }
}
