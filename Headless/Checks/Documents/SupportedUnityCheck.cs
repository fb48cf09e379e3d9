using Headless.Checks.Api;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// Documents that say which Unity the packages are for say what is checked: from the oldest line to the newest, or all lines by name.
/// Changelogs, what was measured once and where the lists come from stay as they were written.
/// </summary>
internal sealed partial class SupportedUnityCheck(ProjectPackages packages)
{
    private static readonly string[] mustSay = ["README.md", "CONTRIBUTING.md", "Packages/com.sphfluid/README.md", "Packages/com.sphfluid/Documentation~/index.md", "Packages/com.sphfluid/Documentation~/platforms.md"];

    /// <summary>2022.3 to 6000.7</summary>
    internal static string Range { get; } = $"{UnityLine.All[0]} to {UnityLine.All[^1]}";

    /// <summary>2022.3, 6000.0, 6000.3, 6000.5 and the alpha 6000.7</summary>
    internal static string Lines { get; } = $"{string.Join(", ", UnityLine.All.SkipLast(1))} and {(UnityLine.All[^1].IsAlpha ? "the alpha " : "")}{UnityLine.All[^1]}";

    public CheckReport Run()
    {
        var report = new CheckReport("Unity that is supported");
        var statements = 0;
        foreach (var document in MarkdownFile.FindAll(packages).Where(d => !IsRecord(d.Shown)))
        {
            var text = Space().Replace(document.Text, " ");
            var said = Claim().Matches(text).Select(m => text[m.Index..]).ToList();
            statements += said.Count;
            report.Findings.AddRange(said.Where(s => !s.StartsWith(Range, StringComparison.Ordinal) && !s.StartsWith(Lines, StringComparison.Ordinal))
                .Select(s => $"{document.Shown}: '{s[..Math.Min(s.Length, 30)]}…' must be '{Range}' or '{Lines}'"));
            if (mustSay.Contains(document.Shown.Replace('\\', '/')) && said.Count == 0) report.Findings.Add($"{document.Shown} does not say '{Range}'");
        }
        report.Figures = $"{statements} statements say {Range}";
        return report;
    }

    private static bool IsRecord(string document) =>
        document.StartsWith("benchmarks", StringComparison.Ordinal) || document.StartsWith("Headless", StringComparison.Ordinal) || document.EndsWith("CHANGELOG.md", StringComparison.Ordinal);

    // The oldest line is named for one reason only. A newer one may be named for what it does otherwise, but not as the start of a range.
    [GeneratedRegex(@"\b20\d\d\.\d\b(?!\.\d)|\b6000\.\d (?:and|or) (?:newer|later)")] private static partial Regex Claim();
    [GeneratedRegex(@"\s+")] private static partial Regex Space();
}
