using System.Globalization;
using System.Text.RegularExpressions;
using System.Text.Json;

namespace Headless.Player.Output;

/// <summary>
/// The folder of <c>--out</c>. A list in it names what the player wrote there; only that is ever replaced or removed. The
/// user's own pictures and films stay, and where one has a name that the player needs, nothing is played.
/// </summary>
public sealed partial class OutputFolder
{
    /// <summary>The list: a name a line.</summary>
    public const string ListName = ".sphplayer-files";

    private const int MostListed = 1_100_000;
    private readonly int frames;

    private OutputFolder(string path, int frames) => (Path, this.frames) = (path, frames);

    public string Path { get; }

    /// <summary>Makes the folder, removes what an earlier run left, and claims the names of this one.</summary>
    /// <param name="out">The value of --out.</param>
    /// <param name="frames">Frames that will be written; 0 for none.</param>
    /// <param name="film">Whether a film will be made.</param>
    /// <exception cref="UsageException">The folder cannot be written, or holds files of these names that are not the player's.</exception>
    public static OutputFolder Open(string @out, int frames, bool film)
    {
        try
        {
            string path = System.IO.Path.GetFullPath(@out);
            if (File.Exists(path)) throw new UsageException($"--out: '{@out}' is a file; name a folder.");
            Directory.CreateDirectory(path);
            var folder = new OutputFolder(path, frames);
            HashSet<string> own = folder.ReadList();
            folder.Refuse(@out, own, film);
            foreach (string name in own)
            {
                // An unfinished file has the name of the finished one with an ending.
                File.Delete(System.IO.Path.Combine(path, name));
                File.Delete(System.IO.Path.Combine(path, name + ".part"));
            }
            folder.WriteList(frames, film);
            return folder;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UsageException($"--out: the folder '{@out}' cannot be written: {e.Message}");
        }
    }

    /// <summary>Lists what was written in the end.</summary>
    public void Close(int written, bool film) => WriteList(written, film);

    private void Refuse(string @out, HashSet<string> own, bool film)
    {
        IEnumerable<string> needed = Directory.EnumerateFiles(Path).Select(f => System.IO.Path.GetFileName(f)!)
            .Where(name => name is TimingsFile.FileName or SummaryFile.FileName || film && name == Film.FileName || IsFrame(name));
        string[] foreign = [.. needed.Where(name => !own.Contains(name)).Order(StringComparer.Ordinal)];
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

    private void WriteList(int written, bool film) => File.WriteAllLines(System.IO.Path.Combine(Path, ListName), Names(written, film));

    private static IEnumerable<string> Names(int frames, bool film) =>
        [TimingsFile.FileName, SummaryFile.FileName, .. film ? [Film.FileName] : Array.Empty<string>(), .. Enumerable.Range(0, frames).Select(FrameWriter.Name)];

    // Whatever a list says, a name of nothing that the player writes is not removed, and none outside the folder.
    private static bool IsOurs(string name) => name is TimingsFile.FileName or SummaryFile.FileName or Film.FileName || FrameName().IsMatch(name);

    [GeneratedRegex(@"^frame_(\d{5,7})\.png$")]
    private static partial Regex FrameName();
}
