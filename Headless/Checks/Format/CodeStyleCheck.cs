using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;
using System.Text.RegularExpressions;

namespace Headless.Checks.Format;

/// <summary>
/// C# of the packages has one style where the formatter leaves a choice: lines of at most max_line_length columns (.editorconfig), access
/// modifiers written, one form of short statements (<see cref="ShortStatement"/>).
/// </summary>
internal sealed partial class CodeStyleCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("style of C#");
        var columns = EditorConfig.MaxLineLength(packages.Project);
        var files = packages.Files().Where(f => f.EndsWith(".cs", StringComparison.Ordinal)).ToList();
        foreach (var file in files)
            report.Findings.AddRange(Faults(File.ReadAllText(file).ReplaceLineEndings("\n"), columns).Select(f => $"{packages.NameOf(file)}({f.Line}): {f.Text}"));
        report.Figures = $"{files.Count} files, lines of at most {columns} columns";
        return report;
    }

    /// <summary>What is wrong in a file, by lines.</summary>
    public static IEnumerable<(int Line, string Text)> Faults(string text, int columns) =>
        SymbolSets(text).SelectMany(symbols => Faults(text, columns, symbols)).Distinct().OrderBy(f => f.Line);

    private static IEnumerable<(int Line, string Text)> Faults(string text, int columns, IEnumerable<string> symbols)
    {
        var tree = CSharpSyntaxTree.ParseText(text, new CSharpParseOptions(LanguageVersion.Latest, preprocessorSymbols: symbols));
        var (root, source) = (tree.GetRoot(), tree.GetText());
        int LineOf(int position) => source.Lines.GetLineFromPosition(position).LineNumber + 1;
        foreach (var line in source.Lines.Where(l => l.Span.Length > columns && !IsOfAString(root, l)))
            yield return (line.LineNumber + 1, $"{line.Span.Length} columns");
        foreach (var member in root.DescendantNodes().Where(AccessModifiers.AreOmitted))
            yield return (LineOf(member.SpanStart), "the access modifier is left out");
        foreach (var statement in root.DescendantNodes().Select(n => ShortStatement.Of(n, source)).OfType<ShortStatement>())
            if (statement.Fault(columns) is { } fault) yield return (LineOf(statement.Start), fault);
    }

    // Text of several lines is as long as it is.
    private static bool IsOfAString(SyntaxNode root, TextLine line) => root.FindToken(line.End).Span is var span && span.Start < line.Start && span.End >= line.End
        || root.FindToken(line.Start).Span is var first && first.Start < line.Start && first.End > line.Start;

    /// <summary>All that conditions of a file name, none, and each alone: nearly every piece of it is compiled in one of them.</summary>
    private static IEnumerable<string[]> SymbolSets(string text)
    {
        var all = Condition().Matches(text).SelectMany(m => Word().Matches(m.Value[m.Value.IndexOf("if", StringComparison.Ordinal)..]).Skip(1).Select(w => w.Value)).Distinct().ToArray();
        return all.Length == 0 ? [[]] : [all, [], .. all.Select(s => new[] { s })];
    }

    [GeneratedRegex(@"^\s*#(?:el)?if .*$", RegexOptions.Multiline)] private static partial Regex Condition();
    [GeneratedRegex(@"\w+")] private static partial Regex Word();
}
