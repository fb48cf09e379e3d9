using System.Globalization;
using System.Text;

namespace Headless.Mutation;

/// <summary>A row of the result: a change, the tests that cover it, and what became of it.</summary>
internal sealed record Row(Mutant Mutant, int Covering, int Run, string First, string Verdict, string By, string Detail)
{
    public const string Caught = "caught", Survived = "survived", Equivalent = "equivalent";

    /// <summary>Changes that are none: they make no program, or the same program as before.</summary>
    public const string Invalid = "does not compile", Same = "same program";

    public bool IsDropped => Verdict is Invalid or Same;
}

/// <summary>The result as a CSV file, and the reasons given by hand.</summary>
internal static class Table
{
    private const string Header = "file,line,operator,source,change,covering_tests,tests_run,first_run,verdict,by,detail";

    public static List<Row> Read(string file)
    {
        if (!File.Exists(file)) return [];
        return [.. Records(File.ReadAllText(file)).Skip(1).Select(f => new Row(
            Place(f[0], int.Parse(f[1], CultureInfo.InvariantCulture), f[2], f[3], f[4]),
            int.Parse(f[5], CultureInfo.InvariantCulture), int.Parse(f[6], CultureInfo.InvariantCulture), f[7], f[8], f[9], f[10]))];
    }

    public static void Write(string file, IEnumerable<Row> rows)
    {
        var text = new StringBuilder(Header).Append('\n');
        foreach (Row row in rows.OrderBy(r => r.Mutant.File, StringComparer.Ordinal).ThenBy(r => r.Mutant.Line).ThenBy(r => r.Mutant.Change, StringComparer.Ordinal))
            text.AppendJoin(',', new[]
            {
                row.Mutant.File, row.Mutant.Line.ToString(CultureInfo.InvariantCulture), row.Mutant.Operator, row.Mutant.Source, row.Mutant.Change,
                row.Covering.ToString(CultureInfo.InvariantCulture), row.Run.ToString(CultureInfo.InvariantCulture), row.First, row.Verdict, row.By, row.Detail,
            }.Select(Quoted)).Append('\n');
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file))!);
        string temporary = file + ".tmp";
        File.WriteAllText(temporary, text.ToString());
        File.Move(temporary, file, overwrite: true);
    }

    /// <summary>Changes that no test can tell from the original, with the reason: columns file, source, change, reason.</summary>
    public static Dictionary<string, string> Reasons(string file) =>
        File.Exists(file)
            ? Records(File.ReadAllText(file)).Skip(1).ToDictionary(f => Place(f[0], 0, "", f[1], f[2]).Key, f => f[3], StringComparer.Ordinal)
            : [];

    // A change that is known by its text alone: the key of Mutant is made of file, source and change.
    private static Mutant Place(string file, int line, string kind, string source, string change) => new StoredMutant(file, line, kind, source, change);

    private static string Quoted(string field)
    {
        string line = string.Join(' ', field.Split(['\r', '\n']));
        return line.AsSpan().IndexOfAny(',', '"') < 0 ? line : '"' + line.Replace("\"", "\"\"") + '"';
    }

    private static List<string[]> Records(string text)
    {
        List<string[]> records = [];
        List<string> fields = [];
        var field = new StringBuilder();
        bool quoted = false;
        for (int i = 0; i < text.Length; i++)
        {
            char c = text[i];
            if (quoted && c == '"' && i + 1 < text.Length && text[i + 1] == '"') { field.Append('"'); i++; }
            else if (c == '"') quoted = !quoted;
            else if (c == ',' && !quoted) { fields.Add(field.ToString()); field.Clear(); }
            else if (c == '\n' && !quoted)
            {
                fields.Add(field.ToString().TrimEnd('\r'));
                field.Clear();
                if (fields.Count > 1) records.Add([.. fields]);
                fields.Clear();
            }
            else field.Append(c);
        }
        return records;
    }
}
