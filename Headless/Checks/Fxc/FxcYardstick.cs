namespace Headless.Checks.Fxc;

/// <summary>A kernel of no use that is compiled again and again among the others. CPU time of a compilation grows on a slow or busy machine;
/// its ratio to the yardstick's does not.</summary>
internal static class FxcYardstick
{
    /// <summary>CPU time of the yardstick on the machine that limits are meant for: a core of a Xeon at 2.5 GHz that does nothing else.</summary>
    public const double ReferenceMilliseconds = 400;

    private const int Every = 15;

    public static readonly FxcJob Job = new("the yardstick", "Yardstick", "cs_5_0", Source());

    /// <summary>A list of jobs with the yardstick's line first, last and after every few.</summary>
    public static List<string> Among(IEnumerable<string> jobs, string yardstick) => [.. jobs.Chunk(Every).SelectMany(chunk => chunk.Prepend(yardstick)), yardstick];

    /// <summary>CPU time of the yardstick, the median of all.</summary>
    public static double Milliseconds(IEnumerable<FxcResult> results)
    {
        var times = results.Where(r => r.Job == Job && r.Ok).Select(r => r.Milliseconds).Order().ToList();
        return times.Count > 0 ? Math.Max(times[times.Count / 2], 1) : ReferenceMilliseconds;
    }

    /// <summary>Results of such a list without the yardstick's, and each time as the reference machine would need it.</summary>
    public static List<FxcResult> Scale(IReadOnlyList<FxcResult> results)
    {
        var scale = ReferenceMilliseconds / Milliseconds(results);
        return [.. results.Where(r => r.Job != Job).Select(r => r with { Milliseconds = (int)Math.Round(r.Milliseconds * scale) })];
    }

    private static string Source()
    {
        using var stream = typeof(FxcYardstick).Assembly.GetManifestResourceStream("Yardstick.hlsl")!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
