using System.Text.RegularExpressions;

namespace Headless.Checks.Format;

/// <summary>C# is laid out as .editorconfig says, by the SDK's formatter.</summary>
internal sealed partial class CodeFormatCheck(string project)
{
    private static readonly string[] folders = ["Headless/", "Packages/", "Assets/"];

    public CheckReport Run()
    {
        var report = new CheckReport("layout of C#");
        var words = new List<string> { "format", "whitespace", project, "--folder", "--verify-no-changes", "--include" };
        words.AddRange(folders);
        if (Tool.Run("dotnet", [.. words]) is not { } result)
        {
            report.SkippedBecause = "dotnet is not on the path";
            return report;
        }
        var places = Place().Matches(result.Output).ToLookup(m => Path.GetRelativePath(project, m.Groups[1].Value), m => m.Groups[2].Value);
        foreach (var file in places) report.Findings.Add($"{file.Key}, line {string.Join(", ", file.Distinct())}: dotnet format whitespace . --folder --include {string.Join(' ', folders)}");
        if (result.Code != 0 && places.Count == 0) report.Findings.Add($"dotnet format ended with exit code {result.Code}: {result.Output}");
        report.Figures = $"{Files().Count()} files";
        return report;
    }

    private IEnumerable<string> Files() => folders.Select(f => Path.Combine(project, f)).Where(Directory.Exists)
        .SelectMany(f => Directory.EnumerateFiles(f, "*.cs", SearchOption.AllDirectories));

    // /p/Headless/A.cs(12,5): error WHITESPACE: Fix whitespace formatting. Replace 4 characters with '\s\s'. [/p]
    [GeneratedRegex(@"^\s*(.+?)\((\d+),\d+\): error ", RegexOptions.Multiline)] private static partial Regex Place();
}
