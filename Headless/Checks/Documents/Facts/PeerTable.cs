using System.Globalization;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// Data/peers.csv: a line for each statement about another program: which, about what, what its page says, the page, and the day on which it was read. One without a
/// source or a day does not count.
/// </summary>
internal sealed class PeerTable
{
    private readonly List<IReadOnlyDictionary<string, string>> rows;

    private PeerTable(IEnumerable<IReadOnlyDictionary<string, string>> rows) => this.rows = [.. rows];

    public static PeerTable Read(string project)
    {
        var table = new PeerTable(CsvTable.Read(Path.Combine(project, "Headless", "Checks", "Documents", "Facts", "Data", "peers.csv")).Rows);
        if (table.rows.Find(r => !Uri.IsWellFormedUriString(r["source"], UriKind.Absolute) || !DateOnly.TryParseExact(r["read"], "yyyy-MM-dd", CultureInfo.InvariantCulture, DateTimeStyles.None, out _)) is { } bad)
            throw new UnknownFactException($"peers.csv: {bad["peer"]}, {bad["about"]}: a source and the day on which it was read");
        return table;
    }

    /// <summary>A row for each program, a column for each question, and when its pages were read.</summary>
    public string Markdown
    {
        get
        {
            string[] peers = [.. rows.Select(r => r["peer"]).Distinct()], about = [.. rows.Select(r => r["about"]).Distinct()];
            return $"| | {string.Join(" | ", about)} | Read |\n|---|{string.Concat(about.Select(_ => "---|"))}---|\n"
                + string.Concat(peers.Select(p => $"| {Head(p)} | {string.Join(" | ", about.Select(a => Cell(p, a)))} | {FactText.Dates(Of(p).Select(r => r["read"]))} |\n"));
        }
    }

    private IEnumerable<IReadOnlyDictionary<string, string>> Of(string peer) => rows.Where(r => r["peer"] == peer);

    // A peer's first line names its page.
    private string Head(string peer) => $"[{peer}]({Of(peer).First()["source"]})";

    private string Cell(string peer, string about)
    {
        if (Of(peer).FirstOrDefault(r => r["about"] == about) is not { } row) return "–";
        return row["source"] == Of(peer).First()["source"] ? row["says"] : $"[{row["says"]}]({row["source"]})";
    }
}
