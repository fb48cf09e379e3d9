using System.Text;
using Headless.Measure.Children;
using Headless.Measure.Parts;

namespace Headless.Measure;

/// <summary>Flags of <c>./run measure</c>.</summary>
internal sealed record MeasureOptions
{
    private const double DefaultMinutes = 10, LeastMinutes = 0.2, MostMinutes = 24 * 60;

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--minutes", "N", "all of it ends within so long", "10"),
        new("--parts", "LIST", "these parts, with commas: " + string.Join(", ", AllParts.Names), "all"),
        Flag.Switch("--small", "the same parts with little in them: a rehearsal, or a CPU"),
        new("--device", "NAME|INDEX", "graphics device, by number or a part of its name", "a real GPU, else the CPU"),
        new("--out", "DIR", "folder for the results: new, empty, or one of an earlier measurement", "Build/measure; measured where it was published"),
        new("--page", "DIR", "measures nothing, and writes the page of such a folder anew"),
        new("--project", "DIR", "folder of the Unity project") { Hidden = true },
        new("--assemblies", "DIR", "folder of its compiled scripts") { Hidden = true },
        new("--fail", "PART=HOW", "lets a part fail: hang, deaf, crash or memory") { Hidden = true },
    ];

    /// <summary>For a machine without ./run.</summary>
    public static string Help
    {
        get
        {
            var text = new StringBuilder("Measures this machine's graphics device, in parts, and writes tables and a page.\n");
            foreach (Flag flag in Flags.Where(f => !f.Hidden)) HelpColumns.Flag(text, flag);
            return text.ToString();
        }
    }

    public required Workplace Place { get; init; }
    public required IReadOnlyList<Part> Parts { get; init; }
    public required string Out { get; init; }
    public double Seconds { get; init; } = DefaultMinutes * 60;
    public bool Small { get; init; }
    public string? Device { get; init; }

    /// <summary>Folder of results whose page is written anew.</summary>
    public string? Page { get; init; }

    /// <summary>Parts that are to fail, for rehearsals of what follows.</summary>
    public IReadOnlyDictionary<string, string> Faults { get; init; } = new Dictionary<string, string>();

    /// <summary>The words as typed, for the page.</summary>
    public string Command { get; init; } = "";

    public static MeasureOptions Parse(IReadOnlyList<string> words)
    {
        var flags = new Arguments("measure", words, Flags);
        Workplace place = Workplace.Find(
            flags.Has("--project") ? flags.Folder("--project") : null, flags.Has("--assemblies") ? flags.Folder("--assemblies") : null);
        return new MeasureOptions
        {
            Place = place,
            Parts = AllParts.Of(flags.Text("--parts")),
            Out = Path.GetFullPath(flags.Text("--out", place.DefaultOut)),
            Seconds = 60 * flags.Number("--minutes", DefaultMinutes, LeastMinutes, MostMinutes, "minutes"),
            Small = flags.Has("--small"),
            Device = flags.Text("--device"),
            Page = flags.Has("--page") ? flags.Folder("--page") : null,
            Faults = Fault(flags.Text("--fail")),
            Command = string.Join(' ', words.Where((_, i) => !IsHidden(words, i))),
        };
    }

    private static bool IsHidden(IReadOnlyList<string> words, int i) =>
        Flags.Any(f => f.Hidden && f.Name != "--fail" && (words[i] == f.Name || i > 0 && words[i - 1] == f.Name));

    private static Dictionary<string, string> Fault(string? text)
    {
        var faults = new Dictionary<string, string>();
        foreach (string pair in (text ?? "").Split(',', StringSplitOptions.RemoveEmptyEntries))
        {
            if (pair.Split('=') is not [var part, var how] || !AllParts.Names.Contains(part) || !FakeFault.Names.Contains(how))
                throw new UsageException($"--fail takes PART=HOW with HOW one of {string.Join(", ", FakeFault.Names)}, found '{pair}'.");
            faults[part] = how;
        }
        return faults;
    }
}
