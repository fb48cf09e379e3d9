namespace Headless.Player.Commands;

/// <summary>Flags of <c>sphplayer test</c>.</summary>
public sealed record TestOptions
{
    private static readonly Dictionary<string, (bool Edit, bool Play)> Modes = new()
    {
        ["edit"] = (true, false), ["play"] = (false, true), ["all"] = (true, true),
    };

    private static readonly Dictionary<string, bool> Compilers = new() { ["glslang"] = false, ["fxc"] = true };

    public required string Project { get; init; }
    public string? Assemblies { get; init; }
    public (bool Edit, bool Play) Mode { get; init; } = (true, true);
    public string Filter { get; init; } = "";

    /// <summary>Whether kernels run as Direct3D's compiler makes them.</summary>
    public bool Direct3D { get; init; }
    public string? Device { get; init; }
    public bool Validate { get; init; }
    public MemoryChecks Checks { get; init; } = new(false, false);

    public static TestOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments(
            "test", words, ["--project", "--assemblies", "--mode", "--filter", "--compiler", "--device"],
            ["--validate", "--poison", "--check-bounds"]);
        MemoryChecks environment = MemoryChecks.FromEnvironment();
        return new TestOptions
        {
            Project = arguments.Folder("--project"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Mode = arguments.OneOf("--mode", Modes["all"], Modes),
            Filter = arguments.Text("--filter", ""),
            Direct3D = arguments.OneOf("--compiler", Compilers["glslang"], Compilers),
            Device = arguments.Text("--device"),
            Validate = arguments.Has("--validate"),
            Checks = new MemoryChecks(
                environment.Poison || arguments.Has("--poison"), environment.Bounds || arguments.Has("--check-bounds")),
        };
    }
}
