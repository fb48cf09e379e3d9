namespace Headless.Player.Commands;

/// <summary>Flags of <c>sphplayer test</c>.</summary>
public sealed record TestOptions
{
    private static readonly Dictionary<string, (bool Edit, bool Play)> Modes = new()
    {
        ["edit"] = (true, false), ["play"] = (false, true), ["all"] = (true, true),
    };

    public required string Project { get; init; }
    public string? Assemblies { get; init; }
    public (bool Edit, bool Play) Mode { get; init; } = (true, true);
    public string Filter { get; init; } = "";
    public string? Device { get; init; }
    public bool Validate { get; init; }

    public static TestOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments("test", words, ["--project", "--assemblies", "--mode", "--filter", "--device"], ["--validate"]);
        return new TestOptions
        {
            Project = arguments.Folder("--project"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Mode = arguments.OneOf("--mode", Modes["all"], Modes),
            Filter = arguments.Text("--filter", ""),
            Device = arguments.Text("--device"),
            Validate = arguments.Has("--validate"),
        };
    }
}
