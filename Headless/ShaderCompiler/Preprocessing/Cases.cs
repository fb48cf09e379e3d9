namespace Headless.Shaders.Preprocessing;

/// <summary>A number of a condition that may differ from variant to variant: which value it has under which condition.</summary>
internal sealed record Cases(IReadOnlyList<(int Condition, int Value)> All)
{
    private const int Most = 64;

    /// <summary>A value that cannot be told: the compiler decides on what hangs on it.</summary>
    public static readonly Cases Unknown = new([]);

    public bool IsKnown => All.Count > 0;

    public static Cases Of(int value) => new([(Decisions.Always, value)]);

    public static Cases Truth(Decisions decisions, int condition) => Merge(decisions, [(condition, 1), (decisions.Not(condition), 0)]);

    /// <summary>When the number is not 0.</summary>
    public int IsTrue(Decisions decisions) => All.Where(c => c.Value != 0).Aggregate(Decisions.Never, (sum, c) => decisions.Or(sum, c.Condition));

    public Cases Map(Decisions decisions, Func<int, int> operation) => Merge(decisions, All.Select(c => (c.Condition, operation(c.Value))));

    /// <param name="operation">Null where it has no value, as in a division by 0.</param>
    public Cases With(Decisions decisions, Cases other, Func<int, int, int?> operation)
    {
        List<(int, int)> all = [];
        foreach ((int condition, int value) in All)
        {
            foreach ((int otherCondition, int otherValue) in other.All)
            {
                int both = decisions.And(condition, otherCondition);
                if (both == Decisions.Never) continue;
                if (operation(value, otherValue) is not { } result) return Unknown;
                all.Add((both, result));
            }
        }
        return Merge(decisions, all);
    }

    public static Cases Merge(Decisions decisions, IEnumerable<(int Condition, int Value)> cases)
    {
        Dictionary<int, int> conditions = [];
        foreach ((int condition, int value) in cases)
        {
            if (condition != Decisions.Never) conditions[value] = decisions.Or(conditions.GetValueOrDefault(value, Decisions.Never), condition);
        }
        return conditions.Count > Most ? Unknown : new Cases([.. conditions.Select(c => (c.Value, c.Key))]);
    }
}
