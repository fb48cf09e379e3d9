using Headless.Measure.Children;
using Headless.Measure.Results;

namespace Headless.Measure.Parts;

/// <summary>The first steps of samples: equal in two runs, and how long equal to those of a software device.</summary>
internal static class StatesPart
{
    /// <summary>Less than a step a frame: the first state that differs names its step. Few steps: what differs is rounding, and not yet chaos.</summary>
    private static readonly string[] words = ["--seconds", "0.2", "--fps", "500", "--size", "64x64", "--no-images"];
    private static readonly string[] samples = ["DamBreak", "FloatingCrates", "Fountain"];

    public static Part Part { get; } = new("states", "are particles equal in two runs, and to a software device's", 6, 8, Run) { SmallWeight = 10 };

    private static PartOutcome Run(PartRun run)
    {
        var lines = new List<string>();
        ChildEnding ending = ChildEnding.Done;
        foreach (string sample in run.Small ? samples[..1] : samples)
        {
            string first = run.In(sample), again = run.In(sample + "-again");
            ChildResult child = PlayTo(run, sample, first);
            if (child.Ending == ChildEnding.Done) child = PlayTo(run, sample, again);
            if (child.Ending != ChildEnding.Done)
            {
                lines.AddRange([$"{sample}: {ChildResult.Word(child.Ending)}", .. PartOutcome.Why(child)]);
                return new PartOutcome(PartOutcome.Worse(ending, child.Ending), lines);
            }
            StateComparison twice = StateComparison.Of(first, again), reference = StateComparison.Of(first, Path.Combine(run.Place.States, sample));
            if (!twice.IsEqual) ending = ChildEnding.Failed;
            else Directory.Delete(again, recursive: true);
            lines.Add($"{sample}, two runs: {twice}");
            lines.Add($"{sample}, against a software device: {reference}");
        }
        return new PartOutcome(ending, lines);
    }

    private static ChildResult PlayTo(PartRun run, string sample, string to) =>
        run.Play(sample, Path.Combine(to, StateComparison.Play), words, ["--surface", "none", "--particles", "500", "--write-sequence", to]);
}
