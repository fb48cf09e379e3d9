using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>Every command of the project's own that a document names has a verb and flags that <c>./run --help</c> has.</summary>
internal sealed partial class CommandCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("commands");
        if (!File.Exists(Path.Combine(packages.Project, "run"))) { report.SkippedBecause = "the project has no ./run"; return report; }
        var help = new CommandHelp(packages.Project);
        var commands = 0;
        foreach (var document in MarkdownFile.FindAll(packages))
            foreach (var (command, line) in Commands(document))
            {
                commands++;
                if (Problem(command, help) is { } problem) report.Findings.Add($"{document.Shown}({line}): {problem}");
            }
        report.Figures = $"{commands} commands of {help.Verbs.Count} verbs";
        return report;
    }

    private static IEnumerable<(string Command, int Line)> Commands(MarkdownFile document)
    {
        foreach (var (code, line) in document.InlineCode())
            foreach (Match command in Command().Matches(code)) yield return (command.Value, line);
        foreach (var fence in document.Fences().Where(f => f.Language is "" or "sh" or "bash" or "shell"))
            foreach (Match command in Command().Matches(fence.Text.Replace("\\\n", "  "))) yield return (command.Value, fence.Line);
    }

    private string? Problem(string command, CommandHelp help)
    {
        var words = Word().Matches(command).Select(m => m.Value).ToList();
        if (words[0] != "./run") return File.Exists(Path.Combine(packages.Project, words[0])) ? null : $"there is no '{words[0]}'";
        var verb = words.Count > 1 && !words[1].StartsWith('-') ? words[1] : "play";
        // VERB stands for each of them.
        if (verb.All(char.IsAsciiLetterUpper)) return null;
        if (verb == "build" || verb == "help") return null;
        if (!help.Verbs.Contains(verb)) return $"'{command.Trim()}': ./run has no verb '{verb}'";
        var unknown = words.Where(w => w.StartsWith("--", StringComparison.Ordinal)).Select(w => w.Split('=')[0]).FirstOrDefault(f => !help.HasFlag(verb, f));
        return unknown is null ? null : $"'{command.Trim()}': ./run {verb} has no flag '{unknown}'";
    }

    [GeneratedRegex(@"(?<![\w./])\./(?:run|test|setup\.sh|Headless/[\w/-]+\.sh)(?![\w.])[^\n;&|>]*")] private static partial Regex Command();
    [GeneratedRegex(@"""[^""]*""|[^\s""`,]+")] private static partial Regex Word();
}
