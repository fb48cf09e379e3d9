namespace Headless.Shaders.Preprocessing;

/// <summary>Follows #if, #ifdef, #ifndef, #elif, #else and #endif, and says whether any variant comes to a place.</summary>
/// <param name="macros">Whose place is kept up to date.</param>
internal sealed class Conditionals(MacroTable macros)
{
    private const int Budget = 1 << 24;

    private readonly MacroExpansion _expansion = new(macros, Budget);
    private readonly Stack<(int Outside, int Others)> _groups = [];
    private int _unknown;

    /// <summary>Whether a variant comes here.</summary>
    public bool Live => macros.Place != Decisions.Never;

    /// <summary>Whether a variant comes here or to another branch of the group.</summary>
    public bool InLiveGroup => !_groups.TryPeek(out (int Outside, int Others) group) || group.Outside != Decisions.Never;

    /// <summary>Takes a directive; false when it is none of these.</summary>
    public bool Take(string directive, string argument)
    {
        switch (directive)
        {
            case "if" or "ifdef" or "ifndef":
                _groups.Push((macros.Place, macros.Place));
                Branch(directive, argument);
                return true;
            case "elif" or "else":
                if (_groups.Count > 0) Branch(directive, argument);
                return true;
            case "endif":
                if (_groups.TryPop(out (int Outside, int Others) ended)) macros.Place = ended.Outside;
                return true;
            default:
                return false;
        }
    }

    private void Branch(string directive, string argument)
    {
        (int outside, int rest) = _groups.Pop();
        macros.Place = rest;
        int condition = rest == Decisions.Never ? Decisions.Never : Condition(directive, argument);
        _groups.Push((outside, macros.Decisions.And(rest, macros.Decisions.Not(condition))));
        macros.Place = macros.Decisions.And(rest, condition);
    }

    private int Condition(string directive, string argument)
    {
        string[] tokens = DirectiveTokens.Read(argument);
        return (directive, tokens) switch
        {
            ("else", _) => Decisions.Always,
            ("ifdef", [var name, ..]) => macros.IsDefined(name),
            ("ifndef", [var name, ..]) => macros.Decisions.Not(macros.IsDefined(name)),
            ("if" or "elif", _) when _expansion.Expand(tokens) is { } expanded => Preprocessing.Condition.IsTrue(expanded, macros.Decisions) ?? Unknown(expanded),
            _ => Unknown([new(argument), new($"{++_unknown}")]),
        };
    }

    // The same condition is the same variable, but for numbers that the expansion tells apart.
    private int Unknown(List<MacroExpansion.Token> tokens) => macros.Decisions.Variable("#if " + string.Join(' ', tokens.Select(t => t.Text)));
}
