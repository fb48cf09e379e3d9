using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Headless.Checks.Documents;

/// <summary>Every piece of C# in a document compiles against the packages and the public API of each Unity line, without what is obsolete there.</summary>
internal sealed class SnippetCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("code in documents");
        var snippets = MarkdownFile.FindAll(packages).SelectMany(Snippet.Of).ToList();
        var check = new ApiCheck(packages);
        var lines = UnityLine.All.Where(l => !l.IsAlpha).ToList();
        foreach (var line in lines)
        {
            var (references, options) = check.ReferencesForUsers(line, string.Join('\n', snippets.Select(s => s.Text)));
            foreach (var snippet in snippets.Where(s => s.NotCompiled is null))
                report.Findings.AddRange(Problems(snippet, references, options).Select(p => $"{snippet.Place}: {p}").Except(report.Findings));
        }
        report.Notes.AddRange(snippets.Where(s => s.NotCompiled is not null).Select(s => $"{s.Place} is not compiled: {s.NotCompiled}"));
        report.Figures = $"{snippets.Count(s => s.NotCompiled is null)} pieces compile against {string.Join(", ", lines)}";
        return report;
    }

    private static IEnumerable<string> Problems(Snippet snippet, IEnumerable<MetadataReference> references, CSharpParseOptions options)
    {
        var compilation = CSharpCompilation.Create("Snippet", [snippet.Parse(options), CSharpSyntaxTree.ParseText(Snippet.Scene, options)], references,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, warningLevel: 4));
        return compilation.GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error || ApiCheck.Obsolete.Contains(d.Id))
            .Select(d => $"line {d.Location.GetMappedLineSpan().StartLinePosition.Line + 1}: {d.Id} {d.GetMessage()}");
    }
}
