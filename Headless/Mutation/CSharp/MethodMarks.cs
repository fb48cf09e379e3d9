using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Headless.Mutation.CSharp;

/// <summary>
/// Numbers the methods of a package and sets a mark in each, so that a test run records which it entered.
/// Members without a body of their own (initial values) count for every method of their file.
/// </summary>
internal sealed class MethodMarks
{
    /// <summary>The player's name for the array of marks.</summary>
    private const string MarksName = "sphplayer.test.marks";

    private readonly Dictionary<string, List<(TextSpan Span, int Mark)>> methods = new(StringComparer.Ordinal);
    private readonly List<string> names = [];
    private readonly List<(string File, string Text)> marked = [];

    public MethodMarks(PackageCompilation package)
    {
        int next = 0;
        foreach (string file in package.Files)
        {
            SyntaxTree tree = package.Tree(file);
            List<(TextSpan, int)> spans = [];
            List<TextChange> changes = [];
            Dictionary<string, int> overloads = new(StringComparer.Ordinal);
            foreach (SyntaxNode node in tree.GetRoot().DescendantNodes())
            {
                if (Change(node, next) is not { } change) continue;
                changes.AddRange(change);
                spans.Add((node.Span, next++));
                string name = NameOf(node);
                overloads[name] = overloads.GetValueOrDefault(name) + 1;
                names.Add($"{file}:{name}#{overloads[name]}");
            }
            methods.Add(file, spans);
            marked.Add((file, tree.GetText().WithChanges(changes.OrderBy(c => c.Span.Start)).ToString()));
        }
        marked.Add(("Runtime/TestMarks.cs",
            $"static class TestMarks {{ static readonly byte[] s = System.AppContext.GetData(\"{MarksName}\") as byte[] ?? new byte[{Math.Max(next, 1)}]; "
            + "public static void Set(int mark) => s[mark] = 1; }"));
    }

    /// <summary>The package's files with their marks.</summary>
    public IReadOnlyList<(string File, string Text)> Marked => marked;

    /// <summary>A mark as "file:Member#1", which holds while others come and go; the second overload is #2.</summary>
    public string Name(int mark) => names[mark];

    public IEnumerable<string> Of(string file) => methods[file].Select(m => names[m.Mark]);

    /// <summary>The innermost method around a place, else all of the file.</summary>
    public IReadOnlyList<string> At(string file, int position)
    {
        List<(TextSpan Span, int Mark)> all = methods[file];
        (TextSpan Span, int Mark)[] around = [.. all.Where(m => m.Span.Contains(position)).OrderBy(m => m.Span.Length)];
        return around.Length > 0 ? [names[around[0].Mark]] : [.. all.Select(m => names[m.Mark])];
    }

    private static string NameOf(SyntaxNode node) => node switch
    {
        MethodDeclarationSyntax method => method.Identifier.Text,
        ConstructorDeclarationSyntax constructor => constructor.Identifier.Text,
        PropertyDeclarationSyntax property => property.Identifier.Text,
        AccessorDeclarationSyntax { Parent.Parent: PropertyDeclarationSyntax owner } accessor => $"{owner.Identifier.Text}.{accessor.Keyword.Text}",
        OperatorDeclarationSyntax made => made.OperatorToken.Text,
        _ => node.Kind().ToString(),
    };

    private static IEnumerable<TextChange>? Change(SyntaxNode node, int mark)
    {
        string call = $"global::TestMarks.Set({mark});";
        switch (node)
        {
            case BaseMethodDeclarationSyntax { Body: { } body }: return [Insert(body, call)];
            case AccessorDeclarationSyntax { Body: { } body }: return [Insert(body, call)];
            case MethodDeclarationSyntax { ExpressionBody: { } arrow } method:
                return Block(arrow, method.SemicolonToken, call, method.ReturnType.ToString() == "void" ? "" : Result(arrow));
            case BaseMethodDeclarationSyntax { ExpressionBody: { } arrow } other:
                return Block(arrow, other.SemicolonToken, call, other is ConstructorDeclarationSyntax or DestructorDeclarationSyntax ? "" : Result(arrow));
            case AccessorDeclarationSyntax { ExpressionBody: { } arrow } accessor:
                return Block(arrow, accessor.SemicolonToken, call, accessor.IsKind(SyntaxKind.GetAccessorDeclaration) ? Result(arrow) : "");
            case PropertyDeclarationSyntax { ExpressionBody: { } arrow } property:
                return Block(arrow, property.SemicolonToken, "get { " + call, Result(arrow), " }");
            case IndexerDeclarationSyntax { ExpressionBody: { } arrow } indexer:
                return Block(arrow, indexer.SemicolonToken, "get { " + call, Result(arrow), " }");
            default: return null;
        }
    }

    private static TextChange Insert(BlockSyntax body, string call) => new(new TextSpan(body.OpenBraceToken.Span.End, 0), " " + call);

    private static string Result(ArrowExpressionClauseSyntax arrow) => arrow.Expression is ThrowExpressionSyntax ? "" : "return ";

    private static IEnumerable<TextChange> Block(ArrowExpressionClauseSyntax arrow, SyntaxToken semicolon, string call, string result, string close = "") =>
    [
        new(arrow.ArrowToken.Span, $"{{ {call} {result}"),
        new(semicolon.Span, "; }" + close),
    ];
}
