using System.Globalization;
using System.Text;

namespace Headless.Measure.Results;

/// <summary>A table of comma-separated values; cells with commas are in quotes.</summary>
internal sealed class CsvTable
{
    private readonly Dictionary<string, int> columns;

    private CsvTable(List<string[]> lines)
    {
        Head = lines.Count > 0 ? lines[0] : [];
        columns = Head.Select((name, i) => (name, i)).DistinctBy(c => c.name).ToDictionary(c => c.name, c => c.i);
        // A line that was cut off while it was written has fewer cells.
        Rows = [.. lines.Skip(1).Where(cells => cells.Length == Head.Length)];
    }

    public string[] Head { get; }
    public IReadOnlyList<string[]> Rows { get; }

    /// <summary>The table of a file; empty where there is none.</summary>
    public static CsvTable Read(string file) => new(File.Exists(file) ? [.. File.ReadLines(file).Where(l => l.Length > 0).Select(Cells)] : []);

    /// <summary>A cell; empty where the table has no such column.</summary>
    public string Text(string[] row, string column) => columns.TryGetValue(column, out int i) ? row[i] : "";

    /// <summary>A number; not a number where the cell has none.</summary>
    public double Number(string[] row, string column) =>
        double.TryParse(Text(row, column), NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? value : double.NaN;

    /// <summary>Writes tables one below the other under one head; those with another head are not taken.</summary>
    public static void Join(IEnumerable<string> files, string to)
    {
        string[][] all = [.. files.Where(File.Exists).Select(File.ReadAllLines).Where(lines => lines.Length > 0)];
        if (all.Length > 0) File.WriteAllLines(to, all.Where(lines => lines[0] == all[0][0]).SelectMany(lines => lines.Skip(1)).Prepend(all[0][0]));
    }

    public static string Cell(string text) => text.AsSpan().IndexOfAny(",\"\n") < 0 ? text : $"\"{text.Replace("\"", "\"\"").ReplaceLineEndings(" ")}\"";

    private static string[] Cells(string line)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        bool quoted = false;
        for (int i = 0; i < line.Length; i++)
        {
            if (line[i] == '"')
            {
                if (quoted && i + 1 < line.Length && line[i + 1] == '"') cell.Append(line[++i]);
                else quoted = !quoted;
            }
            else if (line[i] == ',' && !quoted)
            {
                cells.Add(cell.ToString());
                cell.Clear();
            }
            else cell.Append(line[i]);
        }
        return [.. cells, cell.ToString()];
    }
}
