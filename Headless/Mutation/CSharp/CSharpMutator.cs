using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Headless.Mutation.CSharp;

/// <summary>Every change that it knows of a C# file, by the same operators as for HLSL. Messages, attributes and constants that other assemblies see are left alone.</summary>
internal sealed class CSharpMutator : CSharpSyntaxWalker
{
    private static readonly Dictionary<SyntaxKind, (string Kind, string Other)> Tokens = new()
    {
        [SyntaxKind.AddExpression] = ("arithmetic", "-"), [SyntaxKind.SubtractExpression] = ("arithmetic", "+"),
        [SyntaxKind.MultiplyExpression] = ("arithmetic", "/"), [SyntaxKind.DivideExpression] = ("arithmetic", "*"),
        [SyntaxKind.ModuloExpression] = ("arithmetic", "/"),
        [SyntaxKind.LessThanExpression] = ("relational", "<="), [SyntaxKind.LessThanOrEqualExpression] = ("relational", "<"),
        [SyntaxKind.GreaterThanExpression] = ("relational", ">="), [SyntaxKind.GreaterThanOrEqualExpression] = ("relational", ">"),
        [SyntaxKind.EqualsExpression] = ("relational", "!="), [SyntaxKind.NotEqualsExpression] = ("relational", "=="),
        [SyntaxKind.LogicalAndExpression] = ("logical", "||"), [SyntaxKind.LogicalOrExpression] = ("logical", "&&"),
        [SyntaxKind.BitwiseAndExpression] = ("arithmetic", "|"), [SyntaxKind.BitwiseOrExpression] = ("arithmetic", "&"),
    };

    private static readonly Dictionary<SyntaxKind, string> Assignments = new()
    {
        [SyntaxKind.AddAssignmentExpression] = "-=", [SyntaxKind.SubtractAssignmentExpression] = "+=",
        [SyntaxKind.MultiplyAssignmentExpression] = "/=", [SyntaxKind.DivideAssignmentExpression] = "*=",
    };

    private readonly string file;
    private readonly string text;
    private readonly List<Mutant> found = [];

    private CSharpMutator(string file, string text) => (this.file, this.text) = (file, text);

    public static IReadOnlyList<Mutant> Find(string file, string text)
    {
        var mutator = new CSharpMutator(file, text);
        mutator.Visit(CSharpSyntaxTree.ParseText(text, PackageCompilation.ParseOptions).GetRoot());
        return mutator.found;
    }

    public override void VisitAttributeList(AttributeListSyntax node) { }

    public override void VisitThrowStatement(ThrowStatementSyntax node) { }

    public override void VisitThrowExpression(ThrowExpressionSyntax node) { }

    public override void VisitInterpolatedStringExpression(InterpolatedStringExpressionSyntax node) { }

    public override void VisitParameterList(ParameterListSyntax node) { }

    public override void VisitEnumDeclaration(EnumDeclarationSyntax node) { }

    public override void VisitFieldDeclaration(FieldDeclarationSyntax node)
    {
        bool seen = node.Modifiers.Any(m => m.IsKind(SyntaxKind.PublicKeyword) || m.IsKind(SyntaxKind.InternalKeyword));
        if (!(seen && node.Modifiers.Any(SyntaxKind.ConstKeyword))) base.VisitFieldDeclaration(node);
    }

    public override void VisitBinaryExpression(BinaryExpressionSyntax node)
    {
        if (Tokens.TryGetValue(node.Kind(), out (string Kind, string Other) change)) Add(change.Kind, node.OperatorToken.Span, change.Other);
        if (node.Kind() is SyntaxKind.AddExpression or SyntaxKind.SubtractExpression)
            Add("term", TextSpan.FromBounds(node.OperatorToken.SpanStart, node.Right.Span.End), "");
        base.VisitBinaryExpression(node);
    }

    public override void VisitAssignmentExpression(AssignmentExpressionSyntax node)
    {
        if (Assignments.TryGetValue(node.Kind(), out string? other)) Add("arithmetic", node.OperatorToken.Span, other);
        base.VisitAssignmentExpression(node);
    }

    public override void VisitForStatement(ForStatementSyntax node)
    {
        // The counting is left alone: it would only run without end.
        Visit(node.Declaration);
        Visit(node.Condition);
        Visit(node.Statement);
    }

    public override void VisitLiteralExpression(LiteralExpressionSyntax node)
    {
        if (node.IsKind(SyntaxKind.NumericLiteralExpression) && Constants.Other(node.Token.Text) is { } number) Add("constant", node.Span, number);
        else if (node.IsKind(SyntaxKind.TrueLiteralExpression)) Add("constant", node.Span, "false");
        else if (node.IsKind(SyntaxKind.FalseLiteralExpression)) Add("constant", node.Span, "true");
    }

    public override void VisitPrefixUnaryExpression(PrefixUnaryExpressionSyntax node)
    {
        if (node.IsKind(SyntaxKind.UnaryMinusExpression)) Add("sign", node.OperatorToken.Span, "");
        else if (node.IsKind(SyntaxKind.LogicalNotExpression)) Add("condition", node.OperatorToken.Span, "");
        base.VisitPrefixUnaryExpression(node);
    }

    public override void VisitIfStatement(IfStatementSyntax node)
    {
        Add("condition", node.Condition.Span, $"!({node.Condition})");
        base.VisitIfStatement(node);
    }

    public override void VisitConditionalExpression(ConditionalExpressionSyntax node)
    {
        Add("condition", node.Condition.Span, $"!({node.Condition})");
        base.VisitConditionalExpression(node);
    }

    public override void VisitInvocationExpression(InvocationExpressionSyntax node)
    {
        if (node.Expression is MemberAccessExpressionSyntax { Expression: { } owner, Name: { } name } && owner.ToString() is "Mathf" or "Math" or "math" or "Vector3" or "Vector3Int")
        {
            if (name.Identifier.Text is "Min" or "min") Add("min/max", name.Span, name.Identifier.Text == "Min" ? "Max" : "max");
            else if (name.Identifier.Text is "Max" or "max") Add("min/max", name.Span, name.Identifier.Text == "Max" ? "Min" : "min");
            else if (name.Identifier.Text is "Abs" or "abs" or "Clamp" or "clamp" or "Clamp01" or "saturate") Add("drop function", node.Span, $"({node.ArgumentList.Arguments[0]})");
        }
        base.VisitInvocationExpression(node);
    }

    public override void VisitExpressionStatement(ExpressionStatementSyntax node)
    {
        if (node.Expression is AssignmentExpressionSyntax or InvocationExpressionSyntax or PostfixUnaryExpressionSyntax) Add("statement", node.Span, ";");
        base.VisitExpressionStatement(node);
    }

    private void Add(string kind, TextSpan span, string with) => found.Add(Mutant.Create(file, text, kind, span.Start, span.Length, with));
}
