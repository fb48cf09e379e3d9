namespace Headless.Bench.Model;

/// <summary>Seconds by what they go to; a pass counts whole as what bounds it, issue or chain.</summary>
/// <param name="Chain">Waiting for loads and arithmetic that depend on each other.</param>
/// <param name="Memory">Bytes that no work hides.</param>
/// <param name="Dispatches">Dispatches, barriers and small passes.</param>
internal readonly record struct StepCost(double Issue, double Chain, double Memory, double Dispatches)
{
    public double Total => Issue + Chain + Memory + Dispatches;

    /// <summary>What takes most of it.</summary>
    public string Bound => new[] { (Issue, "issue"), (Chain, "chain"), (Memory, "memory"), (Dispatches, "dispatches") }.MaxBy(part => part.Item1).Item2;

    public static StepCost operator +(StepCost a, StepCost b) => new(a.Issue + b.Issue, a.Chain + b.Chain, a.Memory + b.Memory, a.Dispatches + b.Dispatches);

    public static StepCost operator *(double times, StepCost a) => new(times * a.Issue, times * a.Chain, times * a.Memory, times * a.Dispatches);
}
