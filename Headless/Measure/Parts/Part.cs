using Headless.Measure.Children;

namespace Headless.Measure.Parts;

/// <summary>A part of the measurement.</summary>
/// <param name="Question">What it answers.</param>
/// <param name="Weight">Its share of the time, against the other parts' weights.</param>
/// <param name="Least">Seconds below which it is not begun.</param>
/// <param name="Body">Runs its child processes and reads what they wrote.</param>
internal sealed record Part(string Name, string Question, double Weight, double Least, Func<PartRun, PartOutcome> Body)
{
    /// <summary>Its share of a small measurement, where that is another one.</summary>
    public double? SmallWeight { get; init; }

    /// <summary>Whether nothing can follow where it fails.</summary>
    public bool IsNeeded { get; init; }

    public double WeightOf(bool small) => small && SmallWeight is { } own ? own : Weight;
}

/// <summary>What a part came to.</summary>
/// <param name="Lines">What it found, or why it found nothing, for people.</param>
internal sealed record PartOutcome(ChildEnding Ending, IReadOnlyList<string> Lines)
{
    /// <summary>What a child process came to; with its last lines where it did not end well.</summary>
    public static PartOutcome Of(ChildResult child, IEnumerable<string> found) =>
        new(child.Ending, [.. found, .. child.Ending == ChildEnding.Done ? [] : Why(child)]);

    public static IEnumerable<string> Why(ChildResult child) =>
        child.Tail.Select(line => "| " + line).Prepend(ChildResult.Word(child.Ending) + (child.Code is { } code ? $", exit code {code}" : "") + "; its last lines:");

    public static ChildEnding Worse(ChildEnding a, ChildEnding b) => a > b ? a : b;
}

/// <summary>A line of parts.csv.</summary>
internal sealed record PartResult(string Name, ChildEnding Ending, double Seconds, IReadOnlyList<string> Lines);
