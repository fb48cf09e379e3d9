using System.Globalization;
using Headless.Measure.Children;
using Headless.Measure.Parts;

namespace Headless.Measure.Results;

/// <summary>The folder of results: summary.txt, parts.csv, tables, logs, pictures, and what each part wrote in a folder of its name.</summary>
internal sealed class ResultFolder
{
    public const string Summary = "summary.txt", Parts = "parts.csv", Logs = "logs";

    private ResultFolder(string path) => Path = path;

    public string Path { get; }

    /// <summary>Makes the folder, or empties that of an earlier measurement.</summary>
    /// <exception cref="UsageException">It holds something else.</exception>
    public static ResultFolder Open(string path)
    {
        if (File.Exists(path)) throw new UsageException($"--out: '{path}' is a file; name a folder.");
        bool isOurs = File.Exists(System.IO.Path.Combine(path, Summary)) && File.Exists(System.IO.Path.Combine(path, Parts));
        if (Directory.Exists(path) && !isOurs && Directory.EnumerateFileSystemEntries(path).Any())
            throw new UsageException($"--out: '{path}' holds files that no measurement wrote; name a new folder.");
        if (isOurs) Directory.Delete(path, recursive: true);
        Directory.CreateDirectory(path);
        var folder = new ResultFolder(path);
        File.WriteAllText(System.IO.Path.Combine(path, Summary), "");
        folder.WriteParts([]);
        return folder;
    }

    public string In(params string[] names) => System.IO.Path.Combine([Path, .. names]);

    public void AddToSummary(string line) => File.AppendAllText(In(Summary), line + "\n");

    public void WriteParts(IEnumerable<PartResult> results) => File.WriteAllLines(In(Parts),
        results.Select(r => string.Join(',', r.Name, ChildResult.Word(r.Ending), r.Seconds.ToString("0.0", CultureInfo.InvariantCulture),
            CsvTable.Cell(string.Join(" | ", r.Lines)))).Prepend("part,ending,seconds,found"));
}
