using System.Globalization;

namespace Headless.Bench.Model;

/// <summary>A line of a table, its cells by the names of the columns.</summary>
internal sealed class ModelRow(string file, string[] names, string[] cells)
{
    public bool Has(string column) => Array.IndexOf(names, column) is >= 0 and int at && at < cells.Length && cells[at].Length > 0;

    /// <exception cref="UsageException">There is no such column.</exception>
    public string Text(string column) => Array.IndexOf(names, column) is >= 0 and int at
        ? at < cells.Length ? cells[at].Trim('"') : "" : throw new UsageException($"'{file}' has no column '{column}'.");

    /// <exception cref="UsageException">The cell is no number.</exception>
    public double Number(string column) => double.TryParse(Text(column), NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
        ? value : throw new UsageException($"'{file}': '{Text(column)}' in column '{column}' is no number.");

    public int Whole(string column) => (int)Number(column);
}

/// <summary>Tables of which no cell holds a comma.</summary>
internal static class ModelTable
{
    /// <exception cref="UsageException">The file is missing or empty.</exception>
    public static IReadOnlyList<ModelRow> Read(string file)
    {
        string[] lines = File.Exists(file) ? [.. File.ReadLines(file).Where(line => line.Length > 0)] : [];
        if (lines.Length < 2) throw new UsageException($"'{file}' is missing or has no rows.");
        string[] names = lines[0].Split(',');
        return [.. lines.Skip(1).Select(line => new ModelRow(file, names, line.Split(',')))];
    }
}
