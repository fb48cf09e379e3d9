using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// Relative links and pictures of the project's documents lead to files that are there, and a part of a page that is named (#heading) to a
/// heading. The index.md of each manual lists every page beside it, and so does TableOfContents.md where there is one.
/// </summary>
internal sealed partial class LinkCheck(ProjectPackages packages)
{
    private static readonly string[] lists = ["index.md", "TableOfContents.md"];
    private readonly Dictionary<string, HashSet<string>> headings = [];

    public CheckReport Run()
    {
        var report = new CheckReport("links");
        var documents = MarkdownFile.FindAll(packages);
        var links = 0;
        foreach (var document in documents)
            foreach (var target in Targets(WithoutCode(document.Text)))
            {
                if (target.Contains("://", StringComparison.Ordinal) || target.StartsWith("mailto:", StringComparison.Ordinal)) continue;
                links++;
                if (Problem(document.Path, Uri.UnescapeDataString(target)) is { } problem) report.Findings.Add($"{document.Shown}: the link to '{target}' {problem}");
            }
        foreach (var folder in packages.All.Select(p => Path.Combine(p, "Documentation~")))
            foreach (var list in lists) CheckList(folder, list, report);
        report.Figures = $"{documents.Count} documents, {links} relative links";
        return report;
    }

    private static IEnumerable<string> Targets(string text) => Link().Matches(text).Concat(HtmlLink().Matches(text)).Select(m => m.Groups[1].Value);

    private string? Problem(string document, string target)
    {
        var parts = target.Split('#', 2);
        var file = parts[0].Length == 0 ? document : Path.GetFullPath(Path.Combine(Path.GetDirectoryName(document)!, parts[0]));
        if (!File.Exists(file) && !Directory.Exists(file)) return "leads nowhere";
        return parts.Length == 2 && file.EndsWith(".md", StringComparison.Ordinal) && !HeadingsOf(file).Contains(parts[1]) ? "names no heading of that page" : null;
    }

    private void CheckList(string folder, string list, CheckReport report)
    {
        var index = Path.Combine(folder, list);
        if (!File.Exists(index)) return;
        var listed = Link().Matches(File.ReadAllText(index)).Select(l => l.Groups[1].Value.Split('#')[0]).ToHashSet();
        foreach (var page in Directory.GetFiles(folder, "*.md").Select(f => Path.GetFileName(f)).Where(p => !lists.Contains(p) && !listed.Contains(p)).Order())
            report.Findings.Add($"{Shown(index)} does not list {page}");
    }

    // As GitHub names them: "Force Times Mass (6.3.3)" is force-times-mass-633.
    private HashSet<string> HeadingsOf(string file)
    {
        if (!headings.TryGetValue(file, out var names))
            headings[file] = names = [.. Heading().Matches(WithoutCode(File.ReadAllText(file)))
                .Select(h => NotInAnAnchor().Replace(h.Groups[1].Value.Trim().ToLowerInvariant(), "").Replace(' ', '-'))];
        return names;
    }

    private static string WithoutCode(string text) => Fence().Replace(text, "");

    private string Shown(string path) => Path.GetRelativePath(packages.Project, path);

    [GeneratedRegex(@"\]\(([^()\s]+)(?:\s+""[^""]*"")?\)")] private static partial Regex Link();
    [GeneratedRegex(@"<(?:img|a|source)\b[^>]*\b(?:src|href|srcset)=""([^""]+)""")] private static partial Regex HtmlLink();
    [GeneratedRegex(@"^#{1,6} +(.+?)\s*$", RegexOptions.Multiline)] private static partial Regex Heading();
    [GeneratedRegex(@"[^\w\- ]")] private static partial Regex NotInAnAnchor();
    [GeneratedRegex(@"^```.*?^```", RegexOptions.Multiline | RegexOptions.Singleline)] private static partial Regex Fence();
}
