namespace Headless.Mutation;

/// <summary>
/// The order in which changes are tried. Each file has its own, by the seed and its path, so that an edited file leaves the
/// sample of the others as it was. Files take turns by the square root of how many changes they allow: a small kernel has its
/// share, a large one more.
/// </summary>
internal sealed class Sample
{
    private readonly List<(string File, Queue<Mutant> Left, double Weight)> files = [];
    private readonly Dictionary<string, int> taken = new(StringComparer.Ordinal);

    public Sample(IEnumerable<IReadOnlyList<Mutant>> byFile, int seed)
    {
        foreach (IReadOnlyList<Mutant> all in byFile)
        {
            if (all.Count == 0) continue;
            files.Add((all[0].File, new Queue<Mutant>(Shuffled(all, seed)), Math.Sqrt(all.Count)));
            taken[all[0].File] = 0;
        }
    }

    /// <summary>The next change to try; null when none is left. One that turned out to be none is given back by <see cref="Drop"/>.</summary>
    public Mutant? Next()
    {
        foreach ((string file, Queue<Mutant> left, _) in files.OrderBy(f => (taken[f.File] + 0.5) / f.Weight).ThenBy(f => f.File, StringComparer.Ordinal))
        {
            if (left.Count == 0) continue;
            taken[file]++;
            return left.Dequeue();
        }
        return null;
    }

    /// <summary>The file gets another turn in place of a change that made no other program.</summary>
    public void Drop(Mutant mutant) => taken[mutant.File]--;

    // By line and operator first, so that a line with many constants is not chosen more often than another.
    private static IEnumerable<Mutant> Shuffled(IReadOnlyList<Mutant> all, int seed)
    {
        var random = new Random(Hash(seed + "\n" + all[0].File));
        return all.GroupBy(m => (m.Line, m.Operator))
            .Select(g => (Mutant: g.ElementAt(random.Next(g.Count())), Order: random.Next()))
            .OrderBy(p => p.Order).Select(p => p.Mutant);
    }

    // The same on every machine, unlike string.GetHashCode.
    private static int Hash(string text)
    {
        uint hash = 2166136261;
        foreach (char c in text) hash = (hash ^ c) * 16777619;
        return (int)(hash & 0x7fffffff);
    }
}
