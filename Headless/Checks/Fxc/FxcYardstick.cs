namespace Headless.Checks.Fxc;

/// <summary>A kernel of no use that is compiled again and again among the others. CPU time of a compilation grows on a slow or busy machine;
/// its ratio to the yardstick's does not.</summary>
internal static class FxcYardstick
{
    /// <summary>CPU time of the yardstick on the machine that limits are meant for: a core of a Xeon at 2.5 GHz that does nothing else.</summary>
    public const double ReferenceMilliseconds = 450;

    private const int Every = 15;

    public static readonly FxcJob Job = new("the yardstick", "Yardstick", "cs_5_0", Source());

    /// <summary>A list of jobs with the yardstick's line first, last and after every few.</summary>
    public static List<string> Among(IEnumerable<string> jobs, string yardstick) => [.. jobs.Chunk(Every).SelectMany(chunk => chunk.Prepend(yardstick)), yardstick];

    /// <summary>Results of such a list without the yardstick's, and each time as the reference machine would need it, by the yardstick
    /// before and the one after.</summary>
    public static List<FxcResult> Scale(IReadOnlyList<FxcResult> results)
    {
        var times = results.Where(r => r.Job == Job).Select(r => r.Milliseconds).ToList();
        var passed = 0;
        var scaled = new List<FxcResult>();
        foreach (var result in results)
        {
            if (result.Job == Job) { passed++; continue; }
            var around = (times[passed - 1] + times[Math.Min(passed, times.Count - 1)]) / 2.0;
            scaled.Add(result with { Milliseconds = (int)Math.Round(result.Milliseconds * ReferenceMilliseconds / Math.Max(around, 1)) });
        }
        return scaled;
    }

    private static string Source()
    {
        using var stream = typeof(FxcYardstick).Assembly.GetManifestResourceStream("Yardstick.hlsl")!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
