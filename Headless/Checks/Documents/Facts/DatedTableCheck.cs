using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>A sentence that names a table of benchmarks gives no other day than those of the table's rows.</summary>
internal sealed partial class DatedTableCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("days of tables");
        var days = 0;
        foreach (var document in MarkdownFile.FindAll(packages))
        {
            var text = FactMarker.Read(document.Text);
            foreach (Match statement in Statement().Matches(text))
            {
                var tables = Table().Matches(statement.Value).Select(m => Path.Combine(packages.Project, "benchmarks", m.Groups["path"].Value)).Where(Path.Exists).ToList();
                if (tables.Count == 0) continue;
                var known = tables.SelectMany(DaysOf).ToHashSet();
                if (known.Count == 0) continue;
                foreach (var day in Day().Matches(Table().Replace(statement.Value, "")).Select(m => m.Value))
                {
                    days++;
                    if (!known.Contains(day)) report.Findings.Add($"{document.Shown}: {day} stands beside {Path.GetRelativePath(packages.Project, tables[0])}, whose rows are of {FactText.Dates(known)}");
                }
            }
        }
        report.Figures = $"{days} days beside tables";
        return report;
    }

    private static IEnumerable<string> DaysOf(string table) => (Directory.Exists(table) ? Directory.GetFiles(table, "*.csv") : [table]).Select(f => new CsvTable(File.ReadAllText(f)))
        .Where(t => t.Columns.Contains("date")).SelectMany(t => t.Rows.Select(r => r["date"])).Append(Day().Match(Path.GetFileName(table)).Value).Where(d => d.Length > 0).Distinct();

    // Up to the end of a sentence, a list's item or a pair of brackets about it.
    [GeneratedRegex(@"(?:[^\n.;(]|\.(?=\S)|\((?:[^()]|\([^()]*\))*\)|\n(?![\n|]| *[-*] ))+")] private static partial Regex Statement();
    [GeneratedRegex(@"(?:\.\./)*(?:benchmarks/)(?<path>[\w./-]*\d{4}-\d\d-\d\d[\w-]*(?:/[\w-]+)?(?:\.csv)?)")] private static partial Regex Table();
    [GeneratedRegex(@"\b20\d\d-\d\d-\d\d\b")] private static partial Regex Day();
}
