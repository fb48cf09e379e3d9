namespace Headless.Measure.Parts;

/// <summary>The parts in the order in which they run: what tells most for its time comes first.</summary>
internal static class AllParts
{
    public static IReadOnlyList<Part> All { get; } =
    [
        DevicePart.Part, PlayParts.Frame, StatesPart.Part, TableParts.Solver, TableParts.Surface, PlayParts.Scene, PlayParts.Whitewater,
        PlayParts.Million, TableParts.Chart, TableParts.Water, TestsPart.Part,
    ];

    public static IReadOnlyList<string> Names { get; } = [.. All.Select(p => p.Name)];

    /// <summary>Those that are named, in their own order; all where none is. Nothing runs without the devices' list.</summary>
    public static IReadOnlyList<Part> Of(string? list)
    {
        if (list is null) return All;
        string[] words = list.Split(',', StringSplitOptions.TrimEntries);
        if (words.FirstOrDefault(w => !Names.Contains(w)) is { } unknown)
            throw new UsageException($"--parts: '{unknown}' is not a part{Suggestion.Question(unknown, Names)} The parts are {string.Join(", ", Names)}.");
        return [.. All.Where(p => p.IsNeeded || words.Contains(p.Name))];
    }
}
