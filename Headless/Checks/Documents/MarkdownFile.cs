using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>A fenced block of code: its language as written (empty where none is), its text, the line of its first line, and the comments right before it.</summary>
internal sealed record Fence(string Language, string Text, int Line, string Comments);

/// <summary>A document of the project: its fences, its inline code and its tables, each with its line.</summary>
internal sealed partial class MarkdownFile
{
    private readonly string prose;

    /// <param name="path">The file.</param>
    /// <param name="shown">Its path as findings name it.</param>
    public MarkdownFile(string path, string shown)
    {
        Path = path;
        Shown = shown;
        Text = File.ReadAllText(path).ReplaceLineEndings("\n");
        prose = FenceBlock().Replace(Text, m => new string('\n', m.Value.Count(c => c == '\n')));
    }

    public string Path { get; }
    public string Shown { get; }
    public string Text { get; }

    /// <summary>Every document of a project: those beside its packages and in them, in the player's folder, in benchmarks and in Assets.</summary>
    public static List<MarkdownFile> FindAll(ProjectPackages packages)
    {
        var folders = new[] { "Headless", "benchmarks", "Assets" }.Select(f => System.IO.Path.Combine(packages.Project, f)).Where(Directory.Exists);
        return [.. Directory.GetFiles(packages.Project, "*.md").Concat(folders.SelectMany(f => Directory.GetFiles(f, "*.md", SearchOption.AllDirectories)))
            .Concat(packages.Files().Where(f => f.EndsWith(".md", StringComparison.Ordinal)))
            .Order().Select(f => new MarkdownFile(f, System.IO.Path.GetRelativePath(packages.Project, f)))];
    }

    public IEnumerable<Fence> Fences() => FenceBlock().Matches(Text).Select(m =>
        new Fence(m.Groups["language"].Value.Trim(), m.Groups["text"].Value, LineOf(m.Groups["text"].Index), m.Groups["comments"].Value));

    /// <summary>Code within the lines of the text; a piece that goes over the end of a line has a blank there.</summary>
    public IEnumerable<(string Code, int Line)> InlineCode() =>
        Inline().Matches(prose).Select(m => (m.Groups[1].Value.Replace('\n', ' '), LineOf(m.Index)));

    /// <summary>The rows of each table whose first head cell is one of the names: their first cells, without emphasis.</summary>
    public IEnumerable<(string Cell, int Line)> FirstCells(params string[] heads)
    {
        var lines = prose.Split('\n');
        for (var i = 0; i + 1 < lines.Length; i++)
        {
            if (!lines[i].TrimStart().StartsWith('|') || !Rule().IsMatch(lines[i + 1]) || !heads.Contains(FirstCell(lines[i]))) continue;
            for (i += 2; i < lines.Length && lines[i].TrimStart().StartsWith('|'); i++) yield return (FirstCell(lines[i]), i + 1);
        }
    }

    private static string FirstCell(string row) => row.Trim().Trim('|').Split('|')[0].Replace("*", "").Trim();

    public int LineOf(int index) => Text.AsSpan(0, index).Count('\n') + 1;

    [GeneratedRegex(@"(?<comments>(?:^<!--(?:(?!-->)[\s\S])*-->\n+)*)^ *```(?<language>[^\n`]*)\n(?<text>[\s\S]*?)^ *```[ \t]*$", RegexOptions.Multiline)]
    private static partial Regex FenceBlock();

    [GeneratedRegex(@"(?<!`)`((?:[^`\n]|\n(?!\s*\n))+)`(?!`)")] private static partial Regex Inline();
    [GeneratedRegex(@"^\s*\|(?:\s*:?-+:?\s*\|)+\s*$")] private static partial Regex Rule();
}
