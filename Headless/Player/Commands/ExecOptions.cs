namespace Headless.Player.Commands;

/// <summary>Flags of <c>sphplayer exec</c>.</summary>
public sealed record ExecOptions
{
    internal static readonly IReadOnlyList<Flag> Flags =
    [
        CommonFlags.Project, CommonFlags.Assemblies, CommonFlags.ExecuteMethod("called once; what it leaves runs until it quits"), CommonFlags.Device,
        CommonFlags.Pipeline with { Hidden = true }, CommonFlags.Validate,
    ];

    public required string Project { get; init; }
    public required string ExecuteMethod { get; init; }
    public string? Assemblies { get; init; }
    public string? Device { get; init; }

    /// <summary>Name of the render pipeline; null for the project's.</summary>
    public string? Pipeline { get; init; }
    public bool Validate { get; init; }

    public static ExecOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments("exec", words, Flags);
        return new ExecOptions
        {
            Project = arguments.Folder("--project"),
            ExecuteMethod = arguments.Required("--executeMethod"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Device = arguments.Text("--device"),
            Pipeline = arguments.Text("--pipeline"),
            Validate = arguments.Has("--validate"),
        };
    }
}
