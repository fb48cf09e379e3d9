using System.Globalization;

namespace Headless.Bench.Scene;

/// <summary>Flags of <c>sphbench</c>; the first word is the folder of the build to measure.</summary>
internal sealed record SceneOptions
{
    private static readonly string[] ofTheLiquid = ["--method", "--surface", "--particles", "--seed"];

    public required PlayerBuild Build { get; init; }
    public PlayerBuild? Against { get; init; }

    /// <summary>An earlier scene.csv.</summary>
    public string? AgainstTable { get; init; }
    public required string Scene { get; init; }
    public required ScenePhase[] Phases { get; init; }
    public double Fps { get; init; } = 30;
    public string Size { get; init; } = "1280x720";
    public string? Device { get; init; }
    public required string Out { get; init; }

    /// <summary>Words for the package, behind --.</summary>
    public required string[] Words { get; init; }

    public static SceneOptions Parse(IReadOnlyList<string> words)
    {
        if (words.Count == 0) throw new UsageException("the repository's folder is missing.");
        var build = new PlayerBuild("the repository", words[0]);
        var flags = new Dictionary<string, string>(StringComparer.Ordinal);
        string[] known = ["--table", "--scene", "--against", "--phases", "--fps", "--size", "--device", "--out", .. ofTheLiquid];
        for (int i = 1; i < words.Count; i++)
        {
            string[] parts = words[i].Split('=', 2);
            if (!known.Contains(parts[0])) throw new UsageException($"'{words[i]}' is not a flag of --table scene. Its flags are {string.Join(", ", known)}.");
            if (parts.Length == 1 && i + 1 == words.Count) throw new UsageException($"{parts[0]} needs a value.");
            string value = parts.Length == 2 ? parts[1] : words[++i];
            if (!flags.TryAdd(parts[0], value)) throw new UsageException($"{parts[0]} is given twice.");
        }
        string? against = flags.GetValueOrDefault("--against");
        bool table = against is not null && File.Exists(against);
        string scene = flags.GetValueOrDefault("--scene", Path.Combine(build.Folder, "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity"));
        return new SceneOptions
        {
            Build = build,
            Against = against is null || table ? null : new PlayerBuild("--against", against),
            AgainstTable = table ? against : null,
            Scene = build.SceneOf(scene, build),
            Phases = ScenePhase.ParseList("--phases", flags.GetValueOrDefault("--phases", "0-1,4-5")),
            Fps = Number(flags, "--fps", 30),
            Size = flags.GetValueOrDefault("--size", "1280x720"),
            Device = flags.GetValueOrDefault("--device"),
            Out = flags.GetValueOrDefault("--out", Path.Combine(build.Folder, "Build/bench")),
            Words = [.. ofTheLiquid.Where(flags.ContainsKey).SelectMany(f => new[] { f, flags[f] })],
        };
    }

    private static double Number(Dictionary<string, string> flags, string flag, double absent)
    {
        if (!flags.TryGetValue(flag, out string? text)) return absent;
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value is >= 1 and <= 1000) return value;
        throw new UsageException($"{flag} must be a number from 1 to 1000, found '{text}'.");
    }
}
