namespace Headless.Shaders.Preprocessing;

/// <summary>Macros at a place of the text, and the condition under which a variant comes to it.</summary>
/// <param name="initially">
/// What a name stands for before the first line: one macro, or one for the variants that define it and one for the others.
/// </param>
/// <remarks>After "#ifdef KEYWORD", "#define A 1", "#else", "#define A 2", "#endif", A is 1 where KEYWORD is defined and 2 elsewhere.</remarks>
internal sealed class MacroTable(Func<string, IReadOnlyList<Macro>> initially)
{
    private readonly Dictionary<string, List<(int Condition, Macro Macro)>> _macros = [];

    private readonly HashSet<string> _set = [];

    public Decisions Decisions { get; } = new();

    /// <summary>When the place is reached.</summary>
    public int Place { get; set; } = Decisions.Always;

    /// <summary>What a name stands for here, each under its condition.</summary>
    public IEnumerable<(int Condition, Macro Macro)> this[string name] =>
        All(name).Where(m => Decisions.And(Place, m.Condition) != Decisions.Never);

    /// <summary>What a name stands for, whichever variant comes here; null where that differs.</summary>
    public Macro? Only(string name) => this[name].Take(2).ToArray() is [var (_, macro)] ? macro : null;

    /// <summary>When a name is defined.</summary>
    public int IsDefined(string name) =>
        this[name].Where(m => m.Macro.Defined).Aggregate(Decisions.Never, (sum, m) => Decisions.Or(sum, m.Condition));

    /// <summary>Whether no line of the text has set or undefined a name.</summary>
    public bool IsInitial(string name) => !_set.Contains(name);

    public void Set(string name, Macro macro)
    {
        _set.Add(name);
        int elsewhere = Decisions.Not(Place);
        int here = Place;
        List<(int Condition, Macro Macro)> left = [];
        foreach ((int condition, Macro other) in All(name))
        {
            int rest = Decisions.And(condition, elsewhere);
            if (other.Equals(macro)) here = Decisions.Or(here, rest);
            else if (rest != Decisions.Never) left.Add((rest, other));
        }
        _macros[name] = [(here, macro), .. left];
    }

    private List<(int Condition, Macro Macro)> All(string name)
    {
        if (!_macros.TryGetValue(name, out List<(int, Macro)>? all))
        {
            _macros[name] = all = initially(name) switch
            {
                [var only] => [(Decisions.Always, only)],
                [var defined, var other] => [(Decisions.Variable(name), defined), (Decisions.Not(Decisions.Variable(name)), other)],
                _ => throw new InvalidOperationException(name),
            };
        }
        return all;
    }
}
