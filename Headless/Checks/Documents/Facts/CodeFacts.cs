using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using System.Globalization;

namespace Headless.Checks.Documents.Facts;

/// <summary>Values that the packages' C# gives to fields and constants.</summary>
internal sealed class CodeFacts
{
    private readonly Dictionary<string, List<TypeDeclarationSyntax>> types;

    public CodeFacts(ProjectPackages packages) => types = PackageAssembly.FindAll(packages).Where(a => !a.IsTest).SelectMany(a => a.Parse(["UNITY_EDITOR"]))
        .SelectMany(t => t.GetRoot().DescendantNodes().OfType<TypeDeclarationSyntax>()).GroupBy(t => t.Identifier.Text).ToDictionary(g => g.Key, g => g.ToList());

    /// <summary><c>default:FluidDiagnostics:interval</c>: what a new component has in a field.</summary>
    public string Default(string[] words) => Find(words, isConstant: false);

    /// <summary><c>const:ForceZones:MaxCount</c></summary>
    public string Constant(string[] words) => Find(words, isConstant: true);

    /// <summary>Fields of a type that an inspector shows.</summary>
    public int ShownFields(string type) => Of(type).SelectMany(t => t.Members.OfType<FieldDeclarationSyntax>())
        .Count(f => Names(f).Contains("SerializeField") && !Names(f).Contains("HideInInspector"));

    private static IEnumerable<string> Names(FieldDeclarationSyntax field) => field.AttributeLists.SelectMany(l => l.Attributes).Select(a => a.Name.ToString());

    private string Find(string[] words, bool isConstant)
    {
        if (words.Length != 2) throw new UnknownFactException("a type and a member");
        var field = Variables(words[0]).FirstOrDefault(v => v.Variable.Identifier.Text == words[1] && v.IsConstant == isConstant).Variable
            ?? throw new UnknownFactException($"{words[0]} has no {(isConstant ? "constant" : "field")} '{words[1]}'");
        return field.Initializer is { } given ? Shown(given.Value, words[0]) : WithoutValue(((VariableDeclarationSyntax)field.Parent!).Type.ToString());
    }

    private static string WithoutValue(string type) => type switch
    {
        "bool" => "off",
        "int" or "float" or "double" or "long" => "0",
        _ => "none",
    };

    private IEnumerable<(VariableDeclaratorSyntax Variable, bool IsConstant)> Variables(string type) => Of(type).SelectMany(t => t.Members.OfType<FieldDeclarationSyntax>())
        .SelectMany(f => f.Declaration.Variables.Select(v => (v, f.Modifiers.Any(SyntaxKind.ConstKeyword))));

    private List<TypeDeclarationSyntax> Of(string type) => types.TryGetValue(type, out var found) ? found : throw new UnknownFactException($"there is no type '{type}'");

    private string Shown(ExpressionSyntax value, string type) => value switch
    {
        LiteralExpressionSyntax { Token.Value: bool on } => on ? "on" : "off",
        LiteralExpressionSyntax { Token.Value: string text } => text,
        MemberAccessExpressionSyntax member when !types.ContainsKey(member.Expression.ToString()) || !HasConstant(member) => member.Name.Identifier.Text,
        _ => FactText.Number(Number(value, type)),
    };

    private bool HasConstant(MemberAccessExpressionSyntax member) => Variables(member.Expression.ToString()).Any(v => v.Variable.Identifier.Text == member.Name.Identifier.Text);

    // 1 << 20, 64 * Stride, Other.Max
    private double Number(ExpressionSyntax value, string type) => value switch
    {
        LiteralExpressionSyntax { Token.Value: { } number } => number is float single
            ? double.Parse(single.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture)
            : Convert.ToDouble(number, CultureInfo.InvariantCulture),
        ParenthesizedExpressionSyntax inner => Number(inner.Expression, type),
        PrefixUnaryExpressionSyntax minus when minus.IsKind(SyntaxKind.UnaryMinusExpression) => -Number(minus.Operand, type),
        BinaryExpressionSyntax pair => pair.Kind() switch
        {
            SyntaxKind.AddExpression => Number(pair.Left, type) + Number(pair.Right, type),
            SyntaxKind.SubtractExpression => Number(pair.Left, type) - Number(pair.Right, type),
            SyntaxKind.MultiplyExpression => Number(pair.Left, type) * Number(pair.Right, type),
            SyntaxKind.DivideExpression => Number(pair.Left, type) / Number(pair.Right, type),
            SyntaxKind.LeftShiftExpression => Number(pair.Left, type) * Math.Pow(2, Number(pair.Right, type)),
            _ => throw new UnknownFactException($"'{pair}' is no number"),
        },
        IdentifierNameSyntax name => Constant(type, name.Identifier.Text),
        MemberAccessExpressionSyntax member => Constant(member.Expression.ToString(), member.Name.Identifier.Text),
        SizeOfExpressionSyntax size => size.Type.ToString() is "float" or "int" or "uint" ? 4 : 8,
        CastExpressionSyntax cast => Number(cast.Expression, type),
        _ => throw new UnknownFactException($"'{value}' is no number"),
    };

    private double Constant(string type, string name) => Variables(type).FirstOrDefault(v => v.Variable.Identifier.Text == name).Variable?.Initializer is { } given
        ? Number(given.Value, type)
        : throw new UnknownFactException($"{type} gives '{name}' no value");
}
