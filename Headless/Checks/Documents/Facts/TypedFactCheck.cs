using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>A number that a source has is a fact and not typed: counts of what there is, and bytes of a particle or a cell.</summary>
internal sealed partial class TypedFactCheck(ProjectPackages packages)
{
    private const string Count = @"(?:\d[\d,]*|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|thirteen|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen|twenty)";

    public CheckReport Run()
    {
        var report = new CheckReport("typed numbers");
        var sentences = 0;
        var typed = new Regex($@"\b{Count} (?:\w+ )?(?:{string.Join('|', CountFacts.Names.Values)})\b", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant);
        foreach (var document in MarkdownFile.FindAll(packages).Where(d => !IsRecord(d.Shown.Replace('\\', '/'))))
            foreach (var sentence in Sentence.Of(FactMarker.Blank(document.Text)))
            {
                sentences++;
                foreach (var match in typed.Matches(sentence.Text).Concat(Bytes().Matches(sentence.Text)))
                    report.Findings.Add($"{document.Shown}({sentence.Line}): '{match.Value}' is typed; a fact has it: <!--fact:count:…--> or <!--fact:bytes:…-->");
            }
        report.Figures = $"none in {sentences} sentences";
        return report;
    }

    // What was so once, and what is counted elsewhere.
    private static bool IsRecord(string document) =>
        document.EndsWith("CHANGELOG.md", StringComparison.Ordinal) || document.StartsWith("Headless", StringComparison.Ordinal) || document.StartsWith("benchmarks", StringComparison.Ordinal);

    [GeneratedRegex(@"\b(?:particle|cell)s?\b[^.;|]{0,30}\b(?:needs?|takes?|has|have) \d[\d,]* (?:more )?bytes|\bneeds \d[\d,]* (?:more )?bytes (?:per|a) (?:particle|cell)\b")]
    private static partial Regex Bytes();
}
