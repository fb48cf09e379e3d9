using System.Text;

namespace Headless.Checks.Documents.Facts;

/// <summary>A table with a line of names above its rows; cells may stand in quotation marks.</summary>
internal sealed class CsvTable
{
    private readonly List<string[]> rows;

    public CsvTable(string text)
    {
        var lines = text.ReplaceLineEndings("\n").Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(Cells).ToList();
        Columns = lines.Count > 0 ? lines[0] : [];
        rows = [.. lines.Skip(1)];
    }

    /// <exception cref="UnknownFactException">There is no such file.</exception>
    public static CsvTable Read(string file) => File.Exists(file) ? new CsvTable(File.ReadAllText(file)) : throw new UnknownFactException($"there is no '{Path.GetFileName(file)}'");

    public IReadOnlyList<string> Columns { get; }

    /// <summary>Rows by the names of their cells.</summary>
    public IEnumerable<IReadOnlyDictionary<string, string>> Rows =>
        rows.Select(r => (IReadOnlyDictionary<string, string>)Columns.Select((name, i) => (name, i)).ToDictionary(c => c.name, c => c.i < r.Length ? r[c.i] : ""));

    private static string[] Cells(string line)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        var quoted = false;
        for (var i = 0; i < line.Length; i++)
        {
            if (line[i] == '"' && quoted && i + 1 < line.Length && line[i + 1] == '"') cell.Append(line[i++]);
            else if (line[i] == '"') quoted = !quoted;
            else if (line[i] == ',' && !quoted) { cells.Add(cell.ToString()); cell.Clear(); }
            else cell.Append(line[i]);
        }
        cells.Add(cell.ToString());
        return [.. cells];
    }
}
