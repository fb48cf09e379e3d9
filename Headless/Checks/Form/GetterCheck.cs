using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>A getter assigns no serialised field: reading a property in the Editor would change the scene without undo.</summary>
internal sealed class GetterCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("getters");
        var getters = 0;
        foreach (var (file, type) in PackageTypes.OfPlayers(packages))
        {
            var serialized = SerializedFields(type);
            if (serialized.Count == 0) continue;
            foreach (var property in type.Members.OfType<PropertyDeclarationSyntax>().Where(p => !p.Modifiers.Any(SyntaxKind.StaticKeyword)))
            {
                getters++;
                foreach (var field in Getter(property).SelectMany(Assigned).Where(serialized.Contains).Distinct())
                    report.Findings.Add($"{file}: the getter of {type.Identifier}.{property.Identifier} assigns the serialised field '{field}'");
            }
        }
        report.Figures = $"{getters} properties of types with serialised fields";
        return report;
    }

    private static HashSet<string> SerializedFields(TypeDeclarationSyntax type) => type.Members.OfType<FieldDeclarationSyntax>()
        .Where(f => f.AttributeLists.Has("SerializeField") || (f.Modifiers.Any(SyntaxKind.PublicKeyword) && !f.Modifiers.Any(SyntaxKind.StaticKeyword) && !f.Modifiers.Any(SyntaxKind.ConstKeyword)))
        .SelectMany(f => f.Declaration.Variables.Select(v => v.Identifier.Text)).ToHashSet();

    private static IEnumerable<SyntaxNode> Getter(PropertyDeclarationSyntax property)
    {
        if (property.ExpressionBody is { } body) yield return body;
        foreach (var accessor in property.AccessorList?.Accessors ?? default)
            if (accessor.IsKind(SyntaxKind.GetAccessorDeclaration)) yield return accessor;
    }

    /// <summary>Names that are assigned, counted up or down, or handed over as ref or out; parts of a field count as the field.</summary>
    private static IEnumerable<string> Assigned(SyntaxNode getter)
    {
        foreach (var node in getter.DescendantNodes())
        {
            var target = node switch
            {
                AssignmentExpressionSyntax { Parent: InitializerExpressionSyntax } => null, // a field of a new object
                AssignmentExpressionSyntax assignment => assignment.Left,
                PrefixUnaryExpressionSyntax { RawKind: (int)SyntaxKind.PreIncrementExpression or (int)SyntaxKind.PreDecrementExpression } unary => unary.Operand,
                PostfixUnaryExpressionSyntax { RawKind: (int)SyntaxKind.PostIncrementExpression or (int)SyntaxKind.PostDecrementExpression } unary => unary.Operand,
                ArgumentSyntax { RefKindKeyword.RawKind: (int)SyntaxKind.RefKeyword or (int)SyntaxKind.OutKeyword } argument => argument.Expression,
                _ => null,
            };
            if (target is null) continue;
            foreach (var part in target is TupleExpressionSyntax tuple ? tuple.Arguments.Select(a => a.Expression) : [target])
                if (Root(part) is { } name) yield return name;
        }
    }

    private static string? Root(ExpressionSyntax target) => target switch
    {
        IdentifierNameSyntax name => name.Identifier.Text,
        MemberAccessExpressionSyntax { Expression: ThisExpressionSyntax } member => member.Name.Identifier.Text,
        MemberAccessExpressionSyntax member => Root(member.Expression),
        ElementAccessExpressionSyntax element => Root(element.Expression),
        ParenthesizedExpressionSyntax inner => Root(inner.Expression),
        _ => null,
    };
}
