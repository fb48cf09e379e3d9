using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// The first column of a manual's tables: under "Field" names as the inspector shows them, of serialised fields or of labels that an editor
/// writes; under "Component" those of [AddComponentMenu] and [CreateAssetMenu].
/// </summary>
internal sealed partial class FieldNameCheck(ProjectPackages packages)
{
    private readonly HashSet<string> fields = [];
    private readonly HashSet<string> components = [];

    public CheckReport Run()
    {
        var report = new CheckReport("fields and components in tables");
        ReadSources();
        int rows = 0;
        foreach (var document in MarkdownFile.FindAll(packages))
        {
            foreach (var (cell, line) in document.FirstCells("Field"))
            {
                // `Name` is a field of code, which the reader's compiler knows better.
                if (cell.StartsWith('`')) continue;
                rows++;
                foreach (var name in cell.Split(',').Select(Plain).Where(n => n.Length > 0 && !fields.Contains(n)))
                    report.Findings.Add($"{document.Shown}({line}): no inspector has a field '{name}'");
            }
            foreach (var (cell, line) in document.FirstCells("Component", "Component or asset"))
            {
                rows++;
                if (!components.Contains(cell.Replace(" (asset)", ""))) report.Findings.Add($"{document.Shown}({line}): there is no component or asset '{cell}'");
            }
        }
        report.Figures = $"{rows} rows";
        return report;
    }

    private void ReadSources()
    {
        foreach (var assembly in PackageAssembly.FindAll(packages).Where(a => !a.IsTest))
            foreach (var root in assembly.Parse(["UNITY_EDITOR"]).Select(t => t.GetRoot()))
            {
                foreach (var variable in root.DescendantNodes().OfType<FieldDeclarationSyntax>().SelectMany(f => f.Declaration.Variables))
                    fields.Add(Nicified(variable.Identifier.Text));
                foreach (var literal in root.DescendantNodes().OfType<LiteralExpressionSyntax>().Where(l => l.IsKind(SyntaxKind.StringLiteralExpression)))
                {
                    var text = literal.Token.ValueText;
                    fields.Add(text);
                    if (literal.FirstAncestorOrSelf<AttributeSyntax>()?.Name.ToString() is "AddComponentMenu" or "CreateAssetMenu") components.Add(text.Split('/')[^1]);
                }
            }
    }

    // Letters that a formula gives a field follow its name: "Rest Density ρ0".
    private static string Plain(string cell) => Symbol().Replace(cell, "").Trim();

    /// <summary>As ObjectNames.NicifyVariableName: m_restDensity is Rest Density.</summary>
    private static string Nicified(string name)
    {
        name = name.StartsWith("m_", StringComparison.Ordinal) ? name[2..] : name.TrimStart('_');
        return name.Length == 0 ? "" : Boundary().Replace(char.ToUpperInvariant(name[0]) + name[1..], " ");
    }

    [GeneratedRegex(@"\s+[^\x00-\x7f]\S*$")] private static partial Regex Symbol();
    [GeneratedRegex("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")] private static partial Regex Boundary();
}
