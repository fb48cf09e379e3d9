using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// A sentence that names methods beside something that methods can do names those that can, or says of others that they cannot. One that denies it without naming a method is wrong where any has it.
/// </summary>
internal sealed partial class MethodClaimCheck(ProjectPackages packages, Func<string, IReadOnlyList<string>> with)
{
    private static readonly string[] all = ["Standard", "Robust", "Thesis"];

    public CheckReport Run()
    {
        var report = new CheckReport("methods and what they can do");
        var capabilities = Capability.Read(packages.Project).Where(c => c.Label.Length > 0).ToList();
        var claims = 0;
        foreach (var (shown, sentences) in Texts())
            foreach (var sentence in sentences)
                foreach (var capability in capabilities.Where(c => c.Words.IsMatch(sentence.Text)))
                {
                    if (Problem(sentence.Text, capability, with(capability.Feature), out var named) is { } problem) report.Findings.Add($"{shown}({sentence.Line}): {problem}");
                    if (named) claims++;
                }
        report.Figures = $"{claims} sentences name methods beside {capabilities.Count} capabilities";
        return report;
    }

    internal static string? Problem(string sentence, Capability capability, IReadOnlyList<string> holders, out bool named)
    {
        var text = Aside().Replace(sentence, " ");
        List<string> names = [.. Method().Matches(text).Select(m => m.Value.StartsWith("thesis", StringComparison.OrdinalIgnoreCase) ? "Thesis" : m.Value).Distinct()];
        named = names.Count > 0 && !capability.IsOfAll;
        var denies = Denial().IsMatch(text);
        if (!named) return holders.Count > 0 && DenialOf(capability).IsMatch(text) ? $"'{capability.Words.Match(text).Value}' is denied, which is there: {Shown(sentence)}" : null;
        List<string> missing = [.. holders.Except(names)], wrong = [.. names.Except(holders)];
        if (wrong.Count == 0 && HasNo(capability).IsMatch(text)) return $"{FactText.List(names)} has '{capability.Words.Match(text).Value}': {Shown(sentence)}";
        if (missing.Count == 0 && (wrong.Count == 0 || denies)) return null;
        if (denies && names.TrueForAll(n => !holders.Contains(n))) return null;
        return missing.Count > 0 && wrong.Count < names.Count
            ? $"it names {FactText.List(names)} where {FactText.List(missing)} has '{capability.Words.Match(text).Value}' too: {Shown(sentence)}"
            : $"{FactText.List(wrong)} has no '{capability.Words.Match(text).Value}': {Shown(sentence)}";
    }

    private static string Shown(string sentence) => sentence.Length > 100 ? sentence[..100] + "…" : sentence;

    private static Regex HasNo(Capability capability) => new(
        $@"\b(?:Standard|Robust|Thesis)\b[^.|]{{0,40}}\b(?:(?:has|have) no|lacks?) (?:{capability.Words})", RegexOptions.CultureInvariant);

    private static Regex DenialOf(Capability capability) => new(
        $@"^\W*(?:No|There (?:is|are) no) (?:{capability.Words})|(?:{capability.Words}) (?:is|are) not supported|\b(?:does|do) not support (?:{capability.Words})", RegexOptions.CultureInvariant);

    // What users read: pages of the product and of what adds to it, and what its code says of itself.
    private IEnumerable<(string Shown, IEnumerable<Sentence> Sentences)> Texts()
    {
        foreach (var document in MarkdownFile.FindAll(packages).Where(d => IsForUsers(d.Shown.Replace('\\', '/'))))
            yield return (document.Shown, Sentence.Of(FactMarker.Read(document.Text)));
        foreach (var file in packages.Files().Where(f => f.EndsWith(".cs", StringComparison.Ordinal) && IsProduct(f)))
            yield return (Path.GetRelativePath(packages.Project, file), Spoken(File.ReadAllText(file)));
    }

    private static bool IsForUsers(string document) => !document.EndsWith("CHANGELOG.md", StringComparison.Ordinal) && !document.StartsWith("Headless", StringComparison.Ordinal)
        && !document.StartsWith("benchmarks", StringComparison.Ordinal) && !document.Contains("validation/Documentation~", StringComparison.Ordinal);

    private bool IsProduct(string file) => file.StartsWith(packages.Product + Path.DirectorySeparatorChar, StringComparison.Ordinal) && packages.PathInPackage(file) is var path
        && (path.StartsWith("Runtime", StringComparison.Ordinal) || path.StartsWith("Editor", StringComparison.Ordinal));

    // Comments of members, with the lines that they go over, and texts in quotation marks.
    private static IEnumerable<Sentence> Spoken(string code) => Speech().Matches(code).SelectMany(m =>
        Sentence.Of(Tag().Replace(Mark().Replace(m.Value, " "), "$1 ")).Select(s => s with { Line = code.AsSpan(0, m.Index).Count('\n') + 1 }));

    [GeneratedRegex(@"(?<!Unity's |Unity’s )\b(?:Standard|Robust|Thesis)\b(?! (?:shader|material|Surface|Printed)|Method)|\bthesis(?:'s)? methods?\b")] private static partial Regex Method();
    [GeneratedRegex(@"\b(?:[Tt]he )?[Pp]apers? \*\w+\*(?:(?:,| and) \*\w+\*)*|`[^`]*`|\*\*?Thesis Switches\*?\*?")] private static partial Regex Aside();
    [GeneratedRegex(@"\b(?:no|No|not|nor|never|without|lacks?|ignores?|nothing|cannot|none|neither|passed over|instead|with another|but)\b")] private static partial Regex Denial();
    [GeneratedRegex(@"(?:^[ \t]*///[^\n]*\n?)+|""(?:[^""\\\n]|\\.)*""(?:\s*\+\s*""(?:[^""\\\n]|\\.)*"")*", RegexOptions.Multiline)] private static partial Regex Speech();
    [GeneratedRegex(@"^[ \t]*///|""\s*\+\s*""|""", RegexOptions.Multiline)] private static partial Regex Mark();
    [GeneratedRegex(@"<(?:see|paramref) \w+=""?([^""/>]*)""?/>|<[^>]*>")] private static partial Regex Tag();
}
