using System.Globalization;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// What tables below benchmarks say of themselves: <c>csv:FILE:dates</c>, <c>device</c>, <c>rows</c>, <c>sum:COLUMN</c>, <c>max:COLUMN</c>, <c>least:COLUMN</c> and <c>table:COLUMN:COLUMN+…</c>, each of the rows with
/// <c>COLUMN=VALUE</c> or <c>COLUMN!=VALUE</c>, as many as are named behind it; several values with a + between.
/// </summary>
internal sealed class TableFacts(string project)
{
    public string Find(string[] words)
    {
        if (words.Length < 2) throw new UnknownFactException("a table and what is asked of it");
        var table = CsvTable.Read(Path.Combine(project, "benchmarks", words[0]));
        var conditions = words.Skip(2).Where(w => w.Contains('=')).Select(w => w.Split('=', 2)).ToList();
        var rows = table.Rows.Where(r => conditions.TrueForAll(c => c[1].Split('+').Contains(Of(r, c[0].TrimEnd('!'))) != c[0].EndsWith('!'))).ToList();
        if (rows.Count == 0) throw new UnknownFactException($"{words[0]} has no such row");
        return words[1] switch
        {
            "dates" => FactText.Dates(rows.Select(r => Of(r, "date"))),
            "device" => FactText.List([.. rows.Select(r => FactText.Device(Of(r, "device"))).Distinct()]),
            "rows" => FactText.Number(rows.Count),
            "sum" => FactText.Number(Numbers().Sum()),
            "max" => FactText.Number(Numbers().Max()),
            "least" => FactText.Number(Numbers().Min()),
            "table" => Grouped(rows, words[2], words[3].Split('+')),
            _ => throw new UnknownFactException($"'{words[1]}' is none of dates, device, rows, sum, max, least and table"),
        };

        IEnumerable<double> Numbers() => rows.Select(r => double.Parse(Of(r, words[2]), CultureInfo.InvariantCulture));
    }

    // A row for each value of a column, with the range of what the others have there.
    private static string Grouped(List<IReadOnlyDictionary<string, string>> rows, string by, string[] columns) =>
        $"| {Head(by)} | runs | {string.Join(" | ", columns.Select(Head))} |\n|---|---|{string.Concat(columns.Select(_ => "---|"))}\n" + string.Concat(rows.GroupBy(r => Of(r, by))
            .Select(g => $"| {g.Key} | {g.Count()} | {string.Join(" | ", columns.Select(c => Range([.. g.Select(r => Of(r, c)).Where(v => v.Length > 0)])))} |\n"));

    // speed_m_s is speed m/s
    private static string Head(string column) => column.Replace("_m_s", " m/s").Replace('_', ' ');

    private static string Range(string[] values)
    {
        if (values.Length == 0) return "–";
        var numbers = values.Select(v => Math.Round(double.Parse(v, CultureInfo.InvariantCulture), 3)).ToList();
        return numbers.Min() == numbers.Max() ? FactText.Number(numbers[0]) : $"{FactText.Number(numbers.Min())} to {FactText.Number(numbers.Max())}";
    }

    private static string Of(IReadOnlyDictionary<string, string> row, string column) =>
        row.TryGetValue(column, out var cell) ? cell : throw new UnknownFactException($"the table has no column '{column}'");
}
