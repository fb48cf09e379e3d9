namespace Headless.Player.Commands;

/// <summary>Flags of <c>sphplayer test</c>.</summary>
public sealed record TestOptions
{
    private static readonly Dictionary<string, (bool Edit, bool Play)> Modes = new()
    {
        ["edit"] = (true, false), ["play"] = (false, true), ["all"] = (true, true),
    };

    private static readonly string[] Compilers = ["glslang", "fxc"];

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        CommonFlags.Project, CommonFlags.Assemblies,
        new("--mode", "NAME", "which tests", "all") { Choices = [.. Modes.Keys] },
        new("--filter", "TEXT", "tests whose full names match; several with ';'"),
        new("--tests", "FILE", "tests by full name, one a line, in this order"),
        Flag.Switch("--stop-on-fail", "ends with the first failure"),
        new("--twice", "TEXT", "tests of play mode that run again in a second play, without a domain reload; as in --filter, all with '.'"),
        Flag.Switch("--again", "then each line of standard input names a file of tests to run next"),
        new("--coverage", "FILE", "writes what each test took and used"),
        new("--compiler", "NAME", "what compiles the kernels", "glslang") { Choices = Compilers },
        CommonFlags.Device, CommonFlags.Pipeline, CommonFlags.Validate,
        new("--readback-frames", "N", "frames until an asynchronous read-back arrives, at least", "1"),
        Flag.Switch("--poison", "fills what Unity leaves undefined with set bits"),
        Flag.Switch("--check-bounds", "fails a test whose shader indexes outside a buffer"),
    ];

    public required string Project { get; init; }
    public string? Assemblies { get; init; }
    public (bool Edit, bool Play) Mode { get; init; } = (true, true);
    public string Filter { get; init; } = "";

    /// <summary>Whether kernels run as Direct3D's compiler makes them.</summary>
    public bool Direct3D { get; init; }

    /// <summary>Whole names of tests, in the order in which they run.</summary>
    public IReadOnlyList<string>? Tests { get; init; }

    /// <summary>File for what each test took and used.</summary>
    public string? Coverage { get; init; }
    public bool StopOnFail { get; init; }

    /// <summary>After the run, each line of standard input names a file of tests to run next, with the shaders as they then are.</summary>
    public bool Again { get; init; }

    /// <summary>Which of the tests of play mode run in a second play too; null for none.</summary>
    public string? Twice { get; init; }
    public string? Device { get; init; }

    /// <summary>Name of the render pipeline; null for the project's.</summary>
    public string? Pipeline { get; init; }
    public bool Validate { get; init; }
    public MemoryChecks Checks { get; init; } = new(false, false);

    /// <summary>Frames until an asynchronous read-back arrives, at least.</summary>
    public int ReadbackFrames { get; init; } = 1;

    public static TestOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments("test", words, Flags);
        if (arguments.Has("--filter") && arguments.Has("--tests"))
            throw new UsageException("--filter and --tests both choose the tests: give one of them.");
        MemoryChecks environment = MemoryChecks.FromEnvironment();
        return new TestOptions
        {
            Project = arguments.Folder("--project"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Mode = Modes[arguments.Text("--mode", "all")],
            Filter = arguments.Text("--filter", ""),
            Direct3D = arguments.Text("--compiler") == "fxc",
            Tests = arguments.Has("--tests") ? ReadNames(arguments.Required("--tests")) : null,
            Coverage = arguments.Text("--coverage"),
            Again = arguments.Has("--again"),
            Twice = arguments.Text("--twice"),
            StopOnFail = arguments.Has("--stop-on-fail"),
            Device = arguments.Text("--device"),
            Pipeline = arguments.Text("--pipeline"),
            Validate = arguments.Has("--validate"),
            ReadbackFrames = arguments.Whole("--readback-frames", 1, 1),
            Checks = new MemoryChecks(
                environment.Poison || arguments.Has("--poison"), environment.Bounds || arguments.Has("--check-bounds")),
        };
    }

    public static string[] ReadNames(string file)
    {
        if (!File.Exists(file)) throw new UsageException($"--tests: the file '{file}' does not exist.");
        string[] names = [.. File.ReadLines(file).Select(l => l.Trim()).Where(l => l.Length > 0)];
        return names.Length > 0 ? names : throw new UsageException($"--tests: '{file}' holds no name of a test (one a line).");
    }
}
