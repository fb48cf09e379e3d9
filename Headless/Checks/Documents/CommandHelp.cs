using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// What <c>./run --help</c> says there is: verbs by "./run VERB" at the beginning of a line, and their flags in that line or in the
/// paragraph under the verb's name. A verb's own help is asked only for flags that the common one does not have.
/// </summary>
internal sealed partial class CommandHelp
{
    private readonly string script;
    private readonly Dictionary<string, HashSet<string>> flags = [];
    private readonly HashSet<string> asked = [];

    public CommandHelp(string project)
    {
        script = Path.Combine(project, "run");
        Read(Ask());
    }

    public IReadOnlyCollection<string> Verbs => flags.Keys;

    public bool HasFlag(string verb, string flag)
    {
        if (flag == "--help" || flags[verb].Contains(flag)) return true;
        if (asked.Add(verb)) Read(Ask(verb));
        return flags[verb].Contains(flag);
    }

    // A verb's program may answer --help with its usage and an exit code that is not 0.
    private string[] Ask(params string[] verb) => Tool.Run("bash", [script, .. verb, "--help"]) is { } answer && (answer.Code == 0 || verb.Length > 0)
        ? answer.Output.Split('\n')
        : throw new InvalidOperationException($"'{script} --help' failed.");

    private void Read(string[] lines)
    {
        var section = "";
        foreach (var line in lines)
        {
            if (Usage().Match(line) is { Success: true } usage) Add(section = usage.Groups[1].Value is { Length: > 0 } verb ? verb : "play", line);
            else if (SectionName().Match(line) is { Success: true } name && flags.ContainsKey(name.Groups[1].Value)) section = name.Groups[1].Value;
            else if (line.Length == 0 || line[0] == ' ') Add(section, line);
            else section = "";
        }
    }

    private void Add(string verb, string line)
    {
        if (verb.Length == 0) return;
        if (!flags.TryGetValue(verb, out var known)) flags[verb] = known = [];
        foreach (Match flag in Flag().Matches(line)) known.Add(flag.Value);
    }

    [GeneratedRegex(@"^(?:usage: )?\./run(?: ([a-z]+))?(?=\s|$)")] private static partial Regex Usage();
    [GeneratedRegex(@"^([a-z]+)\b")] private static partial Regex SectionName();
    [GeneratedRegex(@"--[A-Za-z][\w-]*")] private static partial Regex Flag();
}
