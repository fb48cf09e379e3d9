using System.Globalization;
using System.Text.RegularExpressions;
using System.Text.Json;

namespace Headless.Player.Output;

/// <summary>
/// The folder of <c>--out</c>: a new one, an empty one, or one that the player wrote to before. A list in it names what the
/// player wrote; only that is ever replaced or removed, and only once there is something to write in its place.
/// </summary>
public sealed partial class OutputFolder : IDisposable
{
    /// <summary>The list: a name a line.</summary>
    public const string ListName = ".sphplayer-files";

    /// <summary>Held open and locked by the run that writes to the folder. The system unlocks it when the process ends, however that is.</summary>
    public const string LockName = ".sphplayer-lock";

    private const int MostListed = 1_100_000;
    private readonly Lock gate = new();
    private readonly List<string> made = [];
    private readonly int frames;
    private readonly bool film;
    private HashSet<string> own = [];
    private FileStream? held;
    private bool begun;

    private OutputFolder(string path, int frames, bool film) => (Path, this.frames, this.film) = (path, frames, film);

    public string Path { get; }

    /// <summary>Makes the folder and claims it for this run; what is in it stays as it is.</summary>
    /// <param name="out">The value of --out.</param>
    /// <param name="frames">Frames that will be written; 0 for none.</param>
    /// <param name="film">Whether a film will be made.</param>
    /// <exception cref="UsageException">The folder cannot be written, is in use, or holds what the player did not write.</exception>
    public static OutputFolder Open(string @out, int frames, bool film)
    {
        OutputFolder? folder = null;
        try
        {
            string path = System.IO.Path.GetFullPath(@out);
            if (File.Exists(path)) throw new UsageException($"--out: '{@out}' is a file; name a folder.");
            folder = new OutputFolder(path, frames, film);
            if (Directory.Exists(path)) folder.Refuse(@out);
            folder.Claim(@out);
            return folder;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            folder?.Dispose();
            throw new UsageException($"--out: the folder '{@out}' cannot be written: {e.Message}");
        }
        catch (UsageException)
        {
            folder?.Dispose();
            throw;
        }
    }

    /// <summary>Removes what an earlier run left and claims the names of this one; for the first caller, who is about to write.</summary>
    /// <exception cref="IOException">The folder cannot be written.</exception>
    public void Begin()
    {
        lock (gate)
        {
            if (begun) return;
            begun = true;
            // An unfinished file has the name of the finished one with an ending.
            foreach (string file in own.Select(name => System.IO.Path.Combine(Path, name))) WholeFile.Delete(file);
            WriteList(frames, film);
        }
    }

    /// <summary>Lists what was written in the end.</summary>
    public void Close(int written, bool film) => WriteList(written, film);

    /// <summary>Gives the folder up; one that was made for a run that did not begin goes.</summary>
    public void Dispose()
    {
        held?.Dispose();
        held = null;
        if (begun) return;
        foreach (string folder in Enumerable.Reverse(made))
            if (Directory.Exists(folder) && !Directory.EnumerateFileSystemEntries(folder).Any()) Directory.Delete(folder);
    }

    private void Claim(string @out)
    {
        for (string? missing = Path; missing is not null && !Directory.Exists(missing); missing = System.IO.Path.GetDirectoryName(missing)) made.Insert(0, missing);
        Directory.CreateDirectory(Path);
        string file = System.IO.Path.Combine(Path, LockName);
        try
        {
            held = new FileStream(file, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1, FileOptions.DeleteOnClose);
        }
        catch (IOException) when (File.Exists(file))
        {
            throw new UsageException($"--out: another run writes to '{@out}'. Wait for its end, or name another folder.");
        }
    }

    private void Refuse(string @out)
    {
        own = ReadList();
        if (own.Count == 0 && !File.Exists(System.IO.Path.Combine(Path, ListName)) && Directory.EnumerateFileSystemEntries(Path).Any(e => System.IO.Path.GetFileName(e) != LockName))
            throw new UsageException($"--out: '{@out}' is not empty, and the player did not make it. Name a new folder, such as '{System.IO.Path.Combine(@out, "play")}', or an empty one.");
        IEnumerable<string> needed = Directory.EnumerateFileSystemEntries(Path).Select(f => System.IO.Path.GetFileName(f)!)
            .Where(name => name is TimingsFile.FileName or SummaryFile.FileName || film && name == Film.FileName || IsFrame(name));
        string[] foreign = [.. needed.Where(name => !own.Contains(name) || Directory.Exists(System.IO.Path.Combine(Path, name))).Order(StringComparer.Ordinal)];
        if (foreign.Length == 0) return;
        string more = foreign.Length > 1 ? $" and {foreign.Length - 1} more" : "";
        throw new UsageException($"--out: '{@out}' holds {foreign[0]}{more}, which the player did not write and would replace. Name another folder, or move the files away.");
    }

    private bool IsFrame(string name) =>
        FrameName().Match(name) is { Success: true } match && int.Parse(match.Groups[1].ValueSpan, CultureInfo.InvariantCulture) < frames;

    private HashSet<string> ReadList()
    {
        string list = System.IO.Path.Combine(Path, ListName);
        if (!File.Exists(list)) return OfEarlierVersion();
        return [.. File.ReadLines(list).Take(MostListed).Where(IsOurs)];
    }

    /// <summary>Before there was a list, summary.json gave the number of frames.</summary>
    private HashSet<string> OfEarlierVersion()
    {
        string summary = System.IO.Path.Combine(Path, SummaryFile.FileName);
        try
        {
            using JsonDocument json = JsonDocument.Parse(File.ReadAllBytes(summary));
            JsonElement root = json.RootElement;
            if (!root.TryGetProperty("gpu_memory_bytes", out _) || !root.TryGetProperty("wall_s", out _) || !root.TryGetProperty("frames", out JsonElement count)) return [];
            return [.. Names(Math.Clamp(count.GetInt32(), 0, MostListed), film: true)];
        }
        catch (Exception e) when (e is IOException or JsonException or InvalidOperationException or FormatException)
        {
            return [];
        }
    }

    private void WriteList(int written, bool film) =>
        WholeFile.WriteText(System.IO.Path.Combine(Path, ListName), string.Join('\n', Names(written, film)) + "\n");

    private static IEnumerable<string> Names(int frames, bool film) =>
        [TimingsFile.FileName, SummaryFile.FileName, .. film ? [Film.FileName] : Array.Empty<string>(), .. Enumerable.Range(0, frames).Select(FrameWriter.Name)];

    // Whatever a list says, a name of nothing that the player writes is not removed, and none outside the folder.
    private static bool IsOurs(string name) => name is TimingsFile.FileName or SummaryFile.FileName or Film.FileName || FrameName().IsMatch(name);

    [GeneratedRegex(@"^frame_(\d{5,7})\.png$")]
    private static partial Regex FrameName();
}
