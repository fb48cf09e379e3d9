using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Headless.Checks.Format;

/// <summary>
/// An if without else, a for, foreach or while that carries out one simple statement. It stands on one line where that is short enough, else the
/// statement stands on lines of its own in braces.
/// </summary>
internal sealed class ShortStatement
{
    private readonly SourceText source;
    private readonly StatementSyntax whole, body, inner;

    private ShortStatement(SourceText source, StatementSyntax whole, StatementSyntax body, StatementSyntax inner)
    {
        this.source = source;
        this.whole = whole;
        this.body = body;
        this.inner = inner;
    }

    /// <summary>Position of its first letter.</summary>
    public int Start => whole.SpanStart;

    /// <summary>A node as such a statement; null where it is none, or where comments or directives within it decide on its form.</summary>
    public static ShortStatement? Of(SyntaxNode node, SourceText source)
    {
        // if (a) if (b) c(); else d(); is left as it is.
        if (node is not StatementSyntax whole || node.Parent is IfStatementSyntax or ElseClauseSyntax) return null;
        var body = whole switch
        {
            IfStatementSyntax { Else: null } s => s.Statement,
            ForStatementSyntax s => s.Statement,
            CommonForEachStatementSyntax s => s.Statement,
            WhileStatementSyntax s => s.Statement,
            _ => null,
        };
        var inner = body is BlockSyntax { Statements.Count: 1 } block ? block.Statements[0] : body;
        var statement = inner is null || !IsSimple(inner) ? null : new ShortStatement(source, whole, body!, inner);
        return statement is null || statement.HasOwnForm ? null : statement;
    }

    /// <summary>What is wrong with its form; null for nothing.</summary>
    public string? Fault(int columns)
    {
        var line = source.Lines.GetLineFromPosition(Start);
        var joined = Head + " " + Text(inner.Span) + (Tail.Length > 0 ? " " + Tail : "");
        var last = source.Lines.GetLineFromPosition(whole.Span.End);
        var behind = Text(TextSpan.FromBounds(whole.Span.End, last.End)).TrimEnd();
        var fits = !joined.Contains('\n') && Start - line.Start + joined.Length + (behind.TrimStart().StartsWith("//", StringComparison.Ordinal) ? 0 : behind.Length) <= columns;
        if (fits) return Text(whole.Span) == joined || Text(TextSpan.FromBounds(Start, last.End)).TrimEnd() == joined ? null : "a short statement that fits on one line";
        var isFirst = Text(TextSpan.FromBounds(line.Start, Start)).Trim().Length == 0;
        return body is BlockSyntax || !isFirst ? null : "a statement on a line of its own has braces";
    }

    private static bool IsSimple(StatementSyntax s) => s is ExpressionStatementSyntax or ReturnStatementSyntax or BreakStatementSyntax or ContinueStatementSyntax
        or ThrowStatementSyntax or YieldStatementSyntax or GotoStatementSyntax;

    private SyntaxToken Close => (body is BlockSyntax ? body : inner).GetFirstToken().GetPreviousToken();

    /// <summary>if (…)</summary>
    private string Head => Text(TextSpan.FromBounds(Start, Close.Span.End));

    /// <summary>A comment behind the inner statement, within the braces.</summary>
    private string Tail => Text(TextSpan.FromBounds(inner.Span.End, whole.Span.End)).Replace("}", "").Trim();

    private bool HasOwnForm =>
        Text(TextSpan.FromBounds(Close.Span.End, inner.SpanStart)).Replace("{", "").Trim().Length > 0
        || Tail.Length > 0 && (!Tail.StartsWith("//", StringComparison.Ordinal) || Tail.Contains('\n'))
        || whole.DescendantTrivia(descendIntoTrivia: true).Any(t => t.IsDirective);

    private string Text(TextSpan span) => source.ToString(span);
}
