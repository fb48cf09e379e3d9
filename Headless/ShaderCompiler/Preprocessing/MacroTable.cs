namespace Headless.Shaders.Preprocessing;

/// <summary>Macros at a place of the text, where some branches of #if depend on the variant.</summary>
/// <param name="others">What is known of names that the text has not defined.</param>
/// <remarks>
/// Behind a group of such branches stands what all of them agree on: after "#ifdef KEYWORD", "#define A 1", "#else", "#define A 2",
/// "#endif", A is defined, as something that is not known here.
/// </remarks>
internal sealed class MacroTable(Func<string, Macro> others)
{
    private const int MostMerges = 1 << 22;

    private readonly Dictionary<string, Macro> _macros = [];
    private readonly Stack<Group> _groups = [];
    private int _merges;

    private sealed class Group
    {
        /// <summary>What the current branch has changed, as it was before the group.</summary>
        public Dictionary<string, Macro> Before { get; set; } = [];

        /// <summary>What each branch has left of the names that it changed.</summary>
        public List<Dictionary<string, Macro>> Branches { get; } = [];
    }

    /// <summary>Whether so much was merged that the text is meant to take long.</summary>
    public bool IsExhausted => _merges > MostMerges;

    public Macro this[string name]
    {
        get => _macros.TryGetValue(name, out Macro? macro) ? macro : others(name);
        set
        {
            if (_groups.TryPeek(out Group? group)) group.Before.TryAdd(name, this[name]);
            _macros[name] = value;
        }
    }

    /// <summary>Begins a group of branches of which one is taken, or none.</summary>
    public void BeginGroup() => _groups.Push(new Group());

    /// <summary>Ends a branch: the macros are those before the group again.</summary>
    /// <param name="keep">Whether the branch may be taken.</param>
    public void EndBranch(bool keep)
    {
        Group group = _groups.Peek();
        if (keep) group.Branches.Add(group.Before.Keys.ToDictionary(name => name, name => _macros[name]));
        foreach ((string name, Macro before) in group.Before) _macros[name] = before;
        _merges += group.Before.Count;
        group.Before = [];
    }

    /// <summary>Ends a group whose branches were ended; one of them was taken.</summary>
    public void EndGroup()
    {
        Group group = _groups.Pop();
        foreach (string name in group.Branches.SelectMany(b => b.Keys).Distinct())
        {
            Macro before = this[name];
            this[name] = group.Branches.Select(b => b.GetValueOrDefault(name, before)).Aggregate(Macro.Either);
            _merges += group.Branches.Count;
        }
    }
}
