using System.Globalization;

namespace Headless.Mutation;

/// <summary>A wrong flag or file: one line, exit code 2.</summary>
internal sealed class UsageException(string message) : Exception(message);

/// <summary>What the command line asks for.</summary>
internal sealed record Options
{
    public const string Usage = """
        ./run mutate [flags]    changes one operator, constant or term of the package at a time and runs the tests that cover it
          --shaders N           changes of kernels                      125
          --scripts N           changes of C#                           40
          --seed N              which changes                           1
          --files REGEX         files to draw the sample from           shaders of kernels; C# of Solver, Collision, Simulation and Surface
          --only REGEX          files of the sample to change this time all
          --map                 records anew which test covers what (all tests once: minutes)
          --map-filter TEXT     of these tests only, as sphplayer test --filter; the map keeps the others
          --again               also what the table has already
          --survivors           only what the table has as survived
          --seconds S           recorded time of the tests of one change 120
          --list                prints the sample and runs nothing
          --work DIR            folder of the map and of the changed copy       Build/mutation
          --out DIR             folder of mutants.csv and reasons.csv   benchmarks/mutation
        """;

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
        var options = new Options { Project = Path.GetFullPath(words[0]) };
        for (int i = 1; i < words.Length; i++)
        {
            string flag = words[i];
            string Value() => i + 1 < words.Length ? words[++i] : throw new UsageException($"{flag} needs a value.");
            options = flag switch
            {
                "--shaders" => options with { Shaders = Whole(flag, Value()) },
                "--scripts" => options with { Scripts = Whole(flag, Value()) },
                "--seed" => options with { Seed = Whole(flag, Value()) },
                "--files" => options with { Files = Value() },
                "--only" => options with { Only = Value() },
                "--map" => options with { Map = true },
                "--map-filter" => options with { MapFilter = Value() },
                "--again" => options with { Again = true },
                "--survivors" => options with { Survivors = true },
                "--list" => options with { List = true },
                "--seconds" => options with { Seconds = Whole(flag, Value()) },
                "--work" => options with { Work = Path.GetFullPath(Value()) },
                "--out" => options with { Out = Value() },
                _ => throw new UsageException($"'{flag}' is not a flag of mutate."),
            };
        }
        return options;
    }

    private static int Whole(string flag, string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) ? value : throw new UsageException($"{flag} must be a whole number, found '{text}'.");
}
