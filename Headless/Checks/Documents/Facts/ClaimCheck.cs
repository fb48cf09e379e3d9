using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// Every sentence of a list of README.md stands in Data/claims.csv, with what shows it: a test, a table, a picture, or the page that says how far it goes. What shows it is there.
/// </summary>
internal sealed partial class ClaimCheck(ProjectPackages packages)
{
    private const string Page = "README.md";

    public CheckReport Run(bool update)
    {
        var report = new CheckReport("claims of README.md");
        var readme = Path.Combine(packages.Project, Page);
        var list = Path.Combine(packages.Project, "Headless", "Checks", "Documents", "Facts", "Data", "claims.csv");
        if (!File.Exists(readme)) { report.SkippedBecause = "there is none"; return report; }
        var claims = CsvTable.Read(list).Rows.ToDictionary(r => r["claim"], r => r);
        var said = Sentence.Of(FactMarker.Blank(File.ReadAllText(readme).ReplaceLineEndings("\n"))).Where(s => s.IsListed).Select(s => Plain(s.Text)).Distinct().ToList();
        var tests = packages.Files().Concat(Directory.GetFiles(Path.Combine(packages.Project, "Headless", "Tests"), "*.cs", SearchOption.AllDirectories))
            .Where(f => f.EndsWith("Tests.cs", StringComparison.Ordinal)).ToLookup(f => Path.GetFileNameWithoutExtension(f));
        foreach (var claim in said)
            if (!claims.TryGetValue(claim, out var row)) report.Findings.Add($"no line of claims.csv has '{claim}'");
            else if (Problem(row["shown by"], tests) is { } problem) report.Findings.Add($"claims.csv, '{claim}': {problem}");
        report.Findings.AddRange(claims.Keys.Except(said).Select(c => $"claims.csv has a claim that {Page} does not make: '{c}'"));
        if (update && report.Findings.Count > 0) Write(list, said, claims);
        report.Figures = $"{said.Count} claims, each with what shows it";
        return report;
    }

    // A new claim waits for what shows it.
    private static void Write(string list, List<string> said, Dictionary<string, IReadOnlyDictionary<string, string>> claims) => File.WriteAllLines(list,
        said.Select(c => $"{Quoted(c)},{Quoted(claims.TryGetValue(c, out var row) ? row["shown by"] : "")}").Prepend("claim,shown by"));

    private static string Quoted(string cell) => $"\"{cell.Replace("\"", "\"\"")}\"";

    private string? Problem(string evidence, ILookup<string, string> tests)
    {
        if (evidence.Length == 0) return "nothing shows it";
        foreach (var each in evidence.Split(';', StringSplitOptions.TrimEntries))
        {
            var parts = each.Split('.', 2);
            if (parts[0].EndsWith("Tests", StringComparison.Ordinal))
            {
                if (!tests[parts[0]].Any(f => parts.Length < 2 || File.ReadAllText(f).Contains($" {parts[1]}(", StringComparison.Ordinal))) return $"there is no test '{each}'";
            }
            else if (!Path.Exists(Path.Combine(packages.Project, each))) return $"there is no '{each}'";
        }
        return null;
    }

    private static string Plain(string sentence) => Space().Replace(Mark().Replace(sentence, ""), " ").Trim();

    [GeneratedRegex(@"[*`]|^- ")] private static partial Regex Mark();
    [GeneratedRegex(@"\s+")] private static partial Regex Space();
}
