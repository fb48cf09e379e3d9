namespace Headless.Measure;

/// <summary>Where things lie: in a checkout, or in a folder that <c>./run publish --measure</c> wrote, where the program's parent has them.</summary>
internal sealed record Workplace
{
    private const string PublishedProject = "project", Cache = "cache";

    public required string Project { get; init; }
    public required string Assemblies { get; init; }

    /// <summary>What <c>./run model</c> printed: estimates that the page sets beside what is measured; it need not be there.</summary>
    public required string Model { get; init; }

    /// <summary>Particles of a software device, a folder a sample; it need not be there.</summary>
    public required string States { get; init; }

    /// <summary>The commit, where a file says it.</summary>
    public required string CommitFile { get; init; }
    public required string DefaultOut { get; init; }

    /// <summary>Folder of compiled shaders that belongs to the published folder; null for the user's.</summary>
    public string? CacheFolder { get; init; }

    /// <summary>OpenSSL, which .NET's hashes need on Linux, for machines without it; null where this was not published.</summary>
    public string? OpenSsl { get; init; }

    /// <summary>This program: a file, and words that come first.</summary>
    public (string File, string[] Words) Program { get; init; } = Self();

    public string Commit => Environment.GetEnvironmentVariable("SPHFLUID_COMMIT") is { Length: > 0 } commit ? commit
        : File.Exists(CommitFile) ? File.ReadAllText(CommitFile).Trim() : "unknown";

    public static Workplace Find(string? project, string? assemblies)
    {
        string beside = Path.GetFullPath(Path.Combine(AppContext.BaseDirectory, ".."));
        if (project is not null)
            return new Workplace
            {
                Project = Path.GetFullPath(project), Assemblies = assemblies ?? Path.Combine(project, "Build/ScriptAssemblies"),
                Model = Path.Combine(project, "Build/measure-model.txt"), States = Path.Combine(project, "Build/measure-states"),
                CommitFile = "", DefaultOut = Path.Combine(project, "Build/measure"),
            };
        string published = Path.Combine(beside, PublishedProject);
        if (!Directory.Exists(published))
            throw new UsageException($"'{published}' is missing: start this with ./run measure, or as run.sh or run.cmd of a folder of ./run publish --measure.");
        return new Workplace
        {
            Project = published, Assemblies = Path.Combine(AppContext.BaseDirectory, "ScriptAssemblies"), Model = Path.Combine(beside, "model.txt"),
            States = Path.Combine(beside, "states"), CommitFile = Path.Combine(beside, "commit.txt"), DefaultOut = Path.Combine(beside, "measured"),
            CacheFolder = Path.Combine(beside, Cache), OpenSsl = Path.Combine(AppContext.BaseDirectory, "openssl"),
        };
    }

    // Under the dotnet command this program is its first word.
    private static (string, string[]) Self()
    {
        string file = Environment.ProcessPath!, assembly = Path.Combine(AppContext.BaseDirectory, "sphmeasure.dll");
        return Path.GetFileNameWithoutExtension(file) == "sphmeasure" ? (file, []) : ("dotnet", [assembly]);
    }
}
