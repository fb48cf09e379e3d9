namespace Headless.Shaders.Preprocessing;

/// <summary>Follows #if, #ifdef, #ifndef, #elif, #else and #endif, and says whether a place is in a branch that may be taken.</summary>
/// <param name="macros">Kept up to date for the branches.</param>
internal sealed class Conditionals(MacroTable macros)
{
    private const int Budget = 1 << 24;

    private readonly MacroExpansion _expansion = new(macros, Budget);
    private readonly Stack<Group> _groups = [];

    private sealed class Group
    {
        /// <summary>Lies in a branch that is not taken.</summary>
        public required bool Dead { get; init; }

        /// <summary>The branch at hand may be taken.</summary>
        public bool Live { get; set; }

        /// <summary>Whether one of the branches so far is taken where none before it was.</summary>
        public bool Taken { get; set; }

        /// <summary>Whether which branch is taken depends on the variant.</summary>
        public bool Merges { get; set; }

        /// <summary>What follows of the branches so far not being taken.</summary>
        public List<(string Name, bool Defined)> Otherwise { get; } = [];
    }

    /// <summary>Whether the place may be reached.</summary>
    public bool Live => !_groups.TryPeek(out Group? group) || group.Live;

    /// <summary>Whether the place may be reached or lies in another branch of a group that may be.</summary>
    public bool InLiveGroup => !_groups.TryPeek(out Group? group) || !group.Dead;

    /// <summary>Takes a directive; false when it is none of these.</summary>
    public bool Take(string directive, string argument)
    {
        switch (directive)
        {
            case "if" or "ifdef" or "ifndef":
                Group group = new() { Dead = !Live };
                _groups.Push(group);
                Branch(group, directive, argument);
                return true;
            case "elif" or "else":
                if (_groups.TryPeek(out Group? open))
                {
                    EndBranch(open);
                    Branch(open, directive, argument);
                }
                return true;
            case "endif":
                if (_groups.TryPop(out Group? ended)) End(ended);
                return true;
            default:
                return false;
        }
    }

    private void Branch(Group group, string directive, string argument)
    {
        if (group.Dead || group.Taken) return;
        if (group.Merges) Suppose(group.Otherwise);
        bool? known = Truth(directive, argument);
        (string Name, bool Defined)? test = Test(directive, argument);
        if (known is null && !group.Merges)
        {
            macros.BeginGroup();
            group.Merges = true;
        }
        group.Live = known is not false;
        group.Taken = known is true;
        if (group.Merges && !group.Live) macros.EndBranch(keep: false);
        if (known is null && test is var (name, defined))
        {
            Suppose([(name, defined)]);
            group.Otherwise.Add((name, !defined));
        }
    }

    private void EndBranch(Group group)
    {
        if (group.Live && group.Merges) macros.EndBranch(keep: true);
        group.Live = false;
    }

    private void End(Group group)
    {
        EndBranch(group);
        if (!group.Merges) return;
        if (!group.Taken)
        {
            Suppose(group.Otherwise);
            macros.EndBranch(keep: true);
        }
        macros.EndGroup();
    }

    private void Suppose(IEnumerable<(string, bool)> tests)
    {
        foreach ((string name, bool defined) in tests)
        {
            if (macros[name].Defined is null) macros[name] = defined ? Macro.DefinedSomehow : Macro.Undefined;
        }
    }

    private bool? Truth(string directive, string argument)
    {
        if (directive == "else") return true;
        if (Test(directive, argument) is var (name, defined)) return macros[name].Defined is { } known ? known == defined : null;
        return directive is "if" or "elif" && _expansion.Expand(DirectiveTokens.Read(argument)) is { } tokens ? Condition.IsTrue(tokens) : null;
    }

    /// <summary>The name whose being defined is all that a condition asks for.</summary>
    private static (string Name, bool Defined)? Test(string directive, string argument)
    {
        string[] tokens = DirectiveTokens.Read(argument);
        return (directive, tokens) switch
        {
            ("ifdef", [var name, ..]) when DirectiveTokens.IsName(name) => (name, true),
            ("ifndef", [var name, ..]) when DirectiveTokens.IsName(name) => (name, false),
            ("if" or "elif", ["defined", "(", var name, ")"]) => (name, true),
            ("if" or "elif", ["defined", var name]) when DirectiveTokens.IsName(name) => (name, true),
            ("if" or "elif", ["!", "defined", "(", var name, ")"]) => (name, false),
            ("if" or "elif", ["!", "defined", var name]) when DirectiveTokens.IsName(name) => (name, false),
            _ => null,
        };
    }
}
