namespace Headless.Help;

/// <summary>A verb of <c>./run</c>.</summary>
/// <param name="Name">As typed.</param>
/// <param name="Summary">What it does, in a line.</param>
internal sealed record Verb(string Name, string Summary)
{
    /// <summary>What may follow the verb.</summary>
    public string Words { get; init; } = "[flags]";

    /// <summary>Flags that the player itself reads, before the lone <c>--</c>.</summary>
    public IReadOnlyList<Flag> OfPlayer { get; init; } = [];

    /// <summary>Flags of the package, behind the <c>--</c>, or of another program that the verb starts.</summary>
    public IReadOnlyList<Flag> Own { get; init; } = [];

    /// <summary>More flags that hold together with one of those above; the sentence introduces them.</summary>
    public (string Sentence, IReadOnlyList<Flag> Flags)? Other { get; init; }

    /// <summary>Sentences below the flags: files written, what is resumed.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    public IReadOnlyList<(string Words, string Meaning)> Examples { get; init; } = [];

    public IEnumerable<Flag> Flags => OfPlayer.Concat(Own).Where(f => !f.Hidden);

    public override string ToString() => Name;

    public IEnumerable<Flag> AllFlags => Flags.Concat(Other?.Flags ?? []).DistinctBy(f => f.Name);
}
