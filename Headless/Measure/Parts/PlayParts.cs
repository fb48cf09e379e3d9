using Headless.Measure.Children;
using Headless.Measure.Results;

namespace Headless.Measure.Parts;

/// <summary>Scenes that are played: pictures, and what a frame takes.</summary>
internal static class PlayParts
{
    private const string DamBreak = "DamBreak";

    public static Part Frame { get; } = new("frame", "does a scene run and look right", 4, 5, run =>
        Pictures(run, ["--seconds", "0.2", "--size", run.Pick("640x360", "160x90")], run.Pick(4000, 1000)));

    public static Part Scene { get; } = new("scene", "what does a second of Dam Break take", 8, 8, run =>
        Figures(run, run.Pick("5", "0.3"), run.Pick("1280x720", "64x36"), run.Pick<int?>(null, 1000)));

    public static Part Whitewater { get; } = new("whitewater", "what do spray and foam take in its first second", 6, 8, run =>
        Figures(run, run.Pick("1", "0.2"), run.Pick("640x360", "64x36"), run.Pick(65536, 1000)));

    public static Part Million { get; } = new("million", "does a million particles look right, and what is a frame", 12, 10, run =>
        Pictures(run, ["--seconds", run.Pick("2", "0.2"), "--size", run.Pick("1920x1080", "320x180")], run.Pick(1_000_000, 2000)));

    private static PartOutcome Figures(PartRun run, string seconds, string size, int? particles)
    {
        string[] own = particles is { } n ? ["--particles", $"{n}"] : [];
        ChildResult child = run.Play(DamBreak, run.In(), ["--seconds", seconds, "--fps", "30", "--size", size, "--no-images"], own);
        return PartOutcome.Of(child, Found(run));
    }

    private static PartOutcome Pictures(PartRun run, IReadOnlyList<string> words, int particles)
    {
        ChildResult child = run.Play(DamBreak, run.In(), words, ["--particles", $"{particles}"]);
        string[] frames = Directory.Exists(run.In()) ? [.. Directory.EnumerateFiles(run.In(), "frame_*.png").Order(StringComparer.Ordinal)] : [];
        // The middle and the end; the rest would make the folder large.
        string[] shown = frames.Length > 0 ? [.. new[] { frames[frames.Length / 2], frames[^1] }.Distinct()] : [];
        foreach (string file in shown) File.Copy(file, run.Results.In($"{Path.GetFileName(run.In())}-{Path.GetFileName(file)}"), overwrite: true);
        foreach (string file in frames) File.Delete(file);
        return PartOutcome.Of(child, Found(run));
    }

    private static IEnumerable<string> Found(PartRun run) => FrameTimes.Read(run.In("timings.csv")) is { } times ? times.Lines() : [];
}
