using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>Menu paths in documents, messages and comments are those of [MenuItem], [AddComponentMenu] and [CreateAssetMenu].</summary>
internal sealed partial class MenuPathCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("menu paths");
        var items = Items();
        var uses = 0;
        foreach (var file in Texts())
            foreach (Match match in MenuPath().Matches(File.ReadAllText(file)))
            {
                uses++;
                var path = string.Join('/', match.Value.Split('>').Select(p => p.Trim()));
                if (path.StartsWith("Add Component/", StringComparison.Ordinal)) path = path[4..];
                if (!items.Exists(i => i == path || i.StartsWith(path + "/", StringComparison.Ordinal)))
                    report.Findings.Add($"{Path.GetRelativePath(packages.Project, file)}: there is no menu '{match.Value.Trim()}'");
            }
        report.Figures = $"{items.Count} menu items, {uses} mentions";
        return report;
    }

    private List<string> Items()
    {
        var items = new List<string>();
        foreach (var assembly in PackageAssembly.FindAll(packages).Where(a => !a.IsTest))
            foreach (var tree in assembly.Parse(["UNITY_EDITOR"]))
                foreach (var attribute in tree.GetRoot().DescendantNodes().OfType<AttributeSyntax>())
                    if (Prefix(attribute) is { } prefix && Text(PathArgument(attribute), attribute) is { Length: > 0 } path) items.Add(prefix + path);
        return items;

        static ExpressionSyntax? PathArgument(AttributeSyntax attribute)
        {
            var arguments = attribute.ArgumentList?.Arguments ?? default;
            return (arguments.FirstOrDefault(a => a.NameEquals?.Name.Identifier.Text == "menuName") ?? arguments.FirstOrDefault())?.Expression;
        }
    }

    private static string? Prefix(AttributeSyntax attribute) => attribute.Name.ToString().Split('.')[^1] switch
    {
        "MenuItem" => "",
        "AddComponentMenu" => "Component/",
        "CreateAssetMenu" => "Assets/Create/",
        _ => null,
    };

    /// <summary>A literal, a constant of the same file, or a sum of those.</summary>
    private static string Text(ExpressionSyntax? expression, AttributeSyntax place) => expression switch
    {
        LiteralExpressionSyntax literal when literal.IsKind(SyntaxKind.StringLiteralExpression) => literal.Token.ValueText,
        BinaryExpressionSyntax sum when sum.IsKind(SyntaxKind.AddExpression) => Text(sum.Left, place) + Text(sum.Right, place),
        IdentifierNameSyntax name => Text(place.SyntaxTree.GetRoot().DescendantNodes().OfType<VariableDeclaratorSyntax>()
            .FirstOrDefault(v => v.Identifier.Text == name.Identifier.Text)?.Initializer?.Value, place),
        _ => "",
    };

    private IEnumerable<string> Texts() =>
        packages.Files().Where(f => Path.GetExtension(f) is ".md" or ".cs").Concat(Directory.GetFiles(packages.Project, "*.md")).Order();

    [GeneratedRegex("""(?:(?:GameObject > Fluid)|(?:Window > SPH Fluid)|(?:Assets > Create > SPH Fluid)|(?:(?:Add )?Component > SPH Fluid))\b(?: > [^*`"|>.,;:\r\n]+)*""")]
    private static partial Regex MenuPath();
}
