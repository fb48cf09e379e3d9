namespace Headless.Bench.Scene;

/// <summary>What a frame did.</summary>
internal sealed class PlayedFrame
{
    /// <summary>Milliseconds and number of its GPU scopes by name.</summary>
    public Dictionary<string, (double Milliseconds, int Times)> Scopes { get; } = [];

    public long Steps { get; set; }

    /// <summary>
    /// Processor time of all threads of the player [ms]. Where a CPU draws it is the whole frame's cost, and hardly depends on what else
    /// the machine does.
    /// </summary>
    public double Processor { get; set; } = double.NaN;

    /// <summary>Compute dispatches that were recorded; null where the build does not count them.</summary>
    public long? Dispatches { get; set; }

    /// <summary>Milliseconds of a part.</summary>
    public double Time(PassGroup group) => Scopes.Where(s => PassGroups.Of(s.Key) == group).Sum(s => s.Value.Milliseconds);

    /// <summary>How often a scope came.</summary>
    public int Times(string scope) => Scopes.GetValueOrDefault(scope).Times;
}
