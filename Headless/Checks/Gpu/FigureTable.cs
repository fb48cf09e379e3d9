using System.Globalization;

namespace Headless.Checks.Gpu;

/// <summary>Whole numbers by key, as a sorted CSV file whose first line names the compilers that they come from.</summary>
internal sealed class FigureTable(string toolchain, IReadOnlyList<string> keyColumns, IReadOnlyList<string> columns)
{
    public string Toolchain { get; } = toolchain;
    public IReadOnlyList<string> Columns { get; } = columns;

    /// <summary>Figures by key; a key is the text of the key columns, with commas between.</summary>
    public SortedDictionary<string, int[]> Rows { get; } = new(StringComparer.Ordinal);

    public int this[string key, string column] => Rows[key][IndexOf(column)];

    public int IndexOf(string column) => Enumerable.Range(0, Columns.Count).First(i => Columns[i] == column);

    /// <exception cref="FormatException">A line is not one of such a table; the message names file and line.</exception>
    public void Add(string line, string place)
    {
        var fields = line.Split(',');
        var figures = new int[Columns.Count];
        var good = fields.Length == keyColumns.Count + Columns.Count;
        for (var i = 0; good && i < figures.Length; i++)
            good = int.TryParse(fields[keyColumns.Count + i], NumberStyles.Integer, CultureInfo.InvariantCulture, out figures[i]);
        if (!good) throw new FormatException($"{place}: {string.Join(',', [.. keyColumns, .. Columns])} expected, not '{line}'");
        if (!Rows.TryAdd(string.Join(',', fields[..keyColumns.Count]), figures)) throw new FormatException($"{place}: a second line for '{line}'");
    }

    public static string Line(string key, IEnumerable<int> figures) =>
        $"{key},{string.Join(',', figures.Select(f => f.ToString(CultureInfo.InvariantCulture)))}";

    /// <exception cref="FormatException">The file is no such table; the message names file and line.</exception>
    public static FigureTable Read(string path, IReadOnlyList<string> keyColumns, IReadOnlyList<string> columns)
    {
        var lines = File.ReadAllLines(path);
        if (lines.Length < 2 || !lines[0].StartsWith("# ", StringComparison.Ordinal) || lines[1] != string.Join(',', [.. keyColumns, .. columns]))
            throw new FormatException($"{path}: the first two lines are not those of this table; write it anew with --update");
        var table = new FigureTable(lines[0][2..], keyColumns, columns);
        for (var i = 2; i < lines.Length; i++)
            if (lines[i].Length > 0) table.Add(lines[i], $"{path}({i + 1})");
        return table;
    }

    public void Write(string path)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, $"# {Toolchain}\n{string.Join(',', [.. keyColumns, .. Columns])}\n"
            + string.Concat(Rows.Select(row => Line(row.Key, row.Value) + "\n")));
    }
}
