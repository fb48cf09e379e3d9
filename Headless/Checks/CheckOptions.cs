using Headless.Files;

namespace Headless.Checks;

/// <summary>Flags of <c>sphchecks</c>; the first word is the project's folder.</summary>
internal sealed record CheckOptions
{
    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--only", "NAME", "this check alone", "all") { Choices = ["api", "surface", "fxc", "dxc", "cross", "wgsl", "gpu", "buffers", "uniform", "form", "docs", "format"] },
        Flag.Switch("--update",
            "with --only gpu or buffers: writes anew the tables of what Mesa's GPU compilers make of the shaders (Headless/Checks/Gpu/Data), or of the buffers that they use (Headless/Checks/Buffers/Data), to be committed with the reason for every line that got worse; with --only docs: writes the facts of documents, and names the claims of README.md that nothing shows yet"),
        new("--stand-in", "DIR", "folder of the stand-in's assemblies") { Hidden = true },
        new("--cache", "DIR", "folder of Microsoft's compilers", "the player's") { Hidden = true },
        new("--shader-cache", "DIR", "folder of compiled shaders", "shaders in --cache") { Hidden = true },
        // The child process of the GPU check.
        new("--compile-for", "NAME", "compiles every shader for a family of GPUs") { Hidden = true },
    ];

    public required string Project { get; init; }
    public required string Cache { get; init; }
    public required string ShaderCache { get; init; }
    public string? StandIn { get; init; }
    public string? Only { get; init; }
    public string? Family { get; init; }
    public bool Update { get; init; }

    /// <exception cref="UsageException">A flag is unknown, or a value is missing or wrong.</exception>
    public static CheckOptions Parse(IReadOnlyList<string> words)
    {
        string project = words.Count > 0 ? Path.GetFullPath(words[0]) : "";
        if (!Directory.Exists(Path.Combine(project, "Packages"))) throw new UsageException($"no Unity project at '{project}'.");
        var arguments = new Arguments("check", [.. words.Skip(1)], Flags);
        string cache = arguments.Text("--cache", UserCache.Folder);
        string? only = arguments.Text("--only");
        if (arguments.Has("--update") && only is not ("gpu" or "buffers" or "docs"))
            throw new UsageException("--update writes what one check compares: --only gpu --update, --only buffers --update, or --only docs --update.");
        return new CheckOptions
        {
            Project = project,
            Cache = cache,
            ShaderCache = arguments.Text("--shader-cache", Path.Combine(cache, "shaders")),
            StandIn = arguments.Text("--stand-in"),
            Only = only,
            Family = arguments.Text("--compile-for"),
            Update = arguments.Has("--update"),
        };
    }
}
