namespace Headless.Mutation;

/// <summary>What the command line asks for.</summary>
internal sealed record Options
{
    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--shaders", "N", "changes of kernels", "125"),
        new("--scripts", "N", "changes of C#", "40"),
        new("--seed", "N", "which changes", "1"),
        new("--files", "REGEX", "files to draw the sample from", "shaders of kernels; C# of Solver, Collision, Simulation and Surface"),
        new("--only", "REGEX", "files of the sample to change this time", "all"),
        Flag.Switch("--map", "records anew which test covers what (all tests once: minutes)"),
        new("--map-filter", "TEXT", "of these tests only, as sphplayer test --filter; the map keeps the others"),
        Flag.Switch("--again", "also what the table has already"),
        Flag.Switch("--survivors", "only what the table has as survived"),
        new("--seconds", "S", "recorded time of the tests of one change", "120"),
        Flag.Switch("--list", "prints the sample and runs nothing"),
        new("--work", "DIR", "folder of the map and of the changed copy", "Build/mutation"),
        new("--out", "DIR", "folder of mutants.csv and reasons.csv", "benchmarks/mutation"),
    ];

    public required string Project { get; init; }
    public int Shaders { get; init; } = 125;
    public int Scripts { get; init; } = 40;
    public int Seed { get; init; } = 1;
    public string Files { get; init; } = "^Shaders/|^Runtime/(Solver|Collision|Simulation|Surface)/";
    public string Only { get; init; } = "";
    public bool Map { get; init; }
    public string MapFilter { get; init; } = "";
    public bool Again { get; init; }
    public bool Survivors { get; init; }
    public bool List { get; init; }
    public double Seconds { get; init; } = 120.0;
    public string? Out { get; init; }

    public string? Work { get; init; }
    public string Folder => Work ?? Path.Combine(Project, "Build", "mutation");
    public string OutFolder => Out ?? Path.Combine(Project, "benchmarks", "mutation");

    public static Options Parse(string[] words)
    {
        if (words.Length == 0 || !Directory.Exists(Path.Combine(words[0], "Packages", "com.sphfluid"))) throw new UsageException("the first word is the project's folder.");
        var absent = new Options { Project = Path.GetFullPath(words[0]) };
        var arguments = new Arguments("mutate", words[1..], Flags);
        return absent with
        {
            Shaders = arguments.Whole("--shaders", absent.Shaders),
            Scripts = arguments.Whole("--scripts", absent.Scripts),
            Seed = arguments.Whole("--seed", absent.Seed),
            Files = arguments.Text("--files", absent.Files),
            Only = arguments.Text("--only", absent.Only),
            Map = arguments.Has("--map"),
            MapFilter = arguments.Text("--map-filter", absent.MapFilter),
            Again = arguments.Has("--again"),
            Survivors = arguments.Has("--survivors"),
            List = arguments.Has("--list"),
            Seconds = arguments.Whole("--seconds", (int)absent.Seconds),
            Work = arguments.Text("--work") is { } work ? Path.GetFullPath(work) : null,
            Out = arguments.Text("--out"),
        };
    }
}
