using System.Diagnostics;
using System.Runtime.InteropServices;
using Headless.Measure.Children;
using Headless.Measure.Results;

namespace Headless.Measure.Parts;

/// <summary>A part at work: its child processes, its folder and its time.</summary>
internal sealed class PartRun(MeasureOptions options, Part part, ResultFolder folder, TimeSpan limit, CancellationToken stop) : IDisposable
{
    private const string PackageMethod = "SphFluid.Validation.CommandLine.";
    private const string LibraryPath = "LD_LIBRARY_PATH";
    private static readonly bool hasOpenSsl = !OperatingSystem.IsLinux() || NativeLibrary.TryLoad("libssl.so.3", out _);
    private static readonly TimeSpan leastOfAChild = TimeSpan.FromSeconds(1);

    private readonly Stopwatch clock = Stopwatch.StartNew();
    private readonly ChildLog log = new(folder.In(ResultFolder.Logs, part.Name + ".log"));

    public bool Small => options.Small;
    public Workplace Place => options.Place;
    public ResultFolder Results => folder;
    public bool Stopped => stop.IsCancellationRequested;

    /// <summary>Of all its child processes together.</summary>
    public TimeSpan Left => limit - clock.Elapsed;

    /// <summary>A file or folder below the part's own.</summary>
    public string In(params string[] names) => folder.In([part.Name, .. names]);

    /// <summary>The full value, or the small one.</summary>
    public T Pick<T>(T full, T small) => options.Small ? small : full;

    public void Dispose() => log.Dispose();

    /// <summary>The player with a command and its flags.</summary>
    public ChildResult Player(string command, IReadOnlyList<string> words, ChildLog? to = null)
    {
        string[] device = options.Device is { } name ? ["--device", name] : [];
        return Child([command, "--project", Place.Project, "--assemblies", Place.Assemblies, .. device, .. words], to);
    }

    /// <summary>The devices of this machine.</summary>
    public ChildResult Devices() => Child(["devices"], null);

    /// <summary>Plays a sample.</summary>
    /// <param name="words">Flags of the player.</param>
    /// <param name="own">Flags of the package.</param>
    public ChildResult Play(string sample, string to, IReadOnlyList<string> words, IReadOnlyList<string> own)
    {
        string scene = Path.Combine(Place.Project, "Packages/com.sphfluid/Samples~", sample, sample + ".unity");
        return Player("play", ["--scene", scene, "--executeMethod", PackageMethod + "Play", "--out", to, .. words, "--", .. own]);
    }

    /// <summary>A measurement of the package, as <c>./run</c> starts it.</summary>
    public ChildResult Measure(string verb, string to, IReadOnlyList<string> words)
    {
        Directory.CreateDirectory(to);
        return Player("exec", ["--executeMethod", PackageMethod + verb, "--", .. words, "--out", to]);
    }

    /// <summary>Another program of the machine, with its lines in a file.</summary>
    public ChildResult Tool(string file, string program, params string[] words)
    {
        using var lines = new ChildLog(file);
        return Children.Child.Run(new ProcessStartInfo(program, words), Left, lines, stop);
    }

    private ChildResult Child(IReadOnlyList<string> words, ChildLog? to)
    {
        if (Left < leastOfAChild || Stopped) return new ChildResult(ChildEnding.LeftOut, null, ["no time was left for it"]);
        if (options.Faults.TryGetValue(part.Name, out string? fault)) words = [FakeFault.Word, fault];
        var start = new ProcessStartInfo(Place.Program.File, [.. Place.Program.Words, .. words]);
        start.Environment["DOTNET_EnableDiagnostics"] = "0";
        start.Environment["SPHPLAYER_VERB"] = part.Name;
        if (Place.CacheFolder is { } cache) start.Environment["XDG_CACHE_HOME"] = cache;
        if (Place.OpenSsl is { } openSsl && !hasOpenSsl)
        {
            string?[] folders = [Environment.GetEnvironmentVariable(LibraryPath), openSsl];
            start.Environment[LibraryPath] = string.Join(':', folders.Where(f => f is { Length: > 0 }));
        }
        return Children.Child.Run(start, Left, to ?? log, stop);
    }
}
