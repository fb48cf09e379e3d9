namespace Headless.Bench.Scene;

/// <summary>Flags of <c>sphbench</c>; the first word is the folder of the build to measure.</summary>
internal sealed record SceneOptions
{
    private static readonly string[] ofTheLiquid = ["--method", "--surface", "--particles", "--seed", "--profile"];

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--table", "scene", "plays a scene, in turns with another build if one is named") { Choices = ["scene"] },
        new("--scene", "FILE.unity", "the scene; ./run takes the name of a sample, too", "Dam Break, of the samples"),
        new("--phases", "LIST", "spans of simulated seconds, a row each", "0-1,4-5"),
        new("--against", "DIR|FILE", "folder of another build (a checkout in which ./run build Play.slnx was run), or a scene.csv to compare with"),
        new("--fps", "F", "frames a simulated second", "30"),
        new("--size", "WxH", "size of the pictures in pixels", "1280x720"),
        new("--device", "NAME|INDEX", "graphics device (./run devices lists them)", "a real GPU, else the CPU"),
        new("--pipeline", "NAME", "as in play", "the project's"),
        new("--out", "DIR", "folder for the output", "Build/bench"),
        .. ofTheLiquid.Select(name => new Flag(name, "VALUE", "as in play", "as in the scene")),
    ];

    public required PlayerBuild Build { get; init; }
    public PlayerBuild? Against { get; init; }

    /// <summary>An earlier scene.csv.</summary>
    public string? AgainstTable { get; init; }
    public required string Scene { get; init; }
    public required ScenePhase[] Phases { get; init; }
    public double Fps { get; init; } = 30;
    public string Size { get; init; } = "1280x720";
    public string? Device { get; init; }
    public string? Pipeline { get; init; }
    public required string Out { get; init; }

    /// <summary>Words for the package, behind --.</summary>
    public required string[] Words { get; init; }

    public static SceneOptions Parse(IReadOnlyList<string> words)
    {
        if (words.Count == 0) throw new UsageException("the repository's folder is missing.");
        var build = new PlayerBuild("the repository", words[0]);
        var flags = new Arguments("bench --table scene", [.. words.Skip(1)], Flags);
        string? against = flags.Text("--against");
        bool table = against is not null && File.Exists(against);
        string scene = flags.Text("--scene", Path.Combine(build.Folder, "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity"));
        return new SceneOptions
        {
            Build = build,
            Against = against is null || table ? null : new PlayerBuild("--against", against),
            AgainstTable = table ? against : null,
            Scene = build.SceneOf(scene, build),
            Phases = ScenePhase.ParseList("--phases", flags.Text("--phases", "0-1,4-5")),
            Fps = flags.Number("--fps", 30, 1, 1000, "frames a second"),
            Size = flags.Text("--size", "1280x720"),
            Device = flags.Text("--device"),
            Pipeline = flags.Text("--pipeline"),
            Out = flags.Text("--out", Path.Combine(build.Folder, "Build/bench")),
            Words = [.. ofTheLiquid.Where(flags.Has).SelectMany(f => new[] { f, flags.Required(f) })],
        };
    }
}
