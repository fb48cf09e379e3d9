namespace Headless.Measure.Children;

/// <summary>The lines of child processes as a file; each is on the disk at once. The last few are kept, to be quoted.</summary>
internal sealed class ChildLog : IDisposable
{
    /// <summary>A child that repeats itself shall not fill the disk.</summary>
    internal const int MostLines = 50_000;
    private const int Quoted = 6, LongestQuoted = 300;

    private readonly Lock gate = new();
    private readonly Queue<string> last = [];
    private StreamWriter? file;
    private int lines;

    public ChildLog(string path)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        file = new StreamWriter(path, append: true) { AutoFlush = true, NewLine = "\n" };
    }

    public IReadOnlyList<string> Tail
    {
        get
        {
            lock (gate) return [.. last];
        }
    }

    public void Add(string? line)
    {
        if (line is null) return;
        lock (gate)
        {
            if (file is null) return;
            lines++;
            if (lines <= MostLines) file.WriteLine(line);
            if (lines == MostLines) file.WriteLine($"... what follows of more than {MostLines} lines is left out");
            if (string.IsNullOrWhiteSpace(line)) return;
            last.Enqueue(line.Length > LongestQuoted ? line[..LongestQuoted] + "..." : line);
            if (last.Count > Quoted) last.Dequeue();
        }
    }

    public void Dispose()
    {
        lock (gate)
        {
            file?.Dispose();
            file = null;
        }
    }
}
