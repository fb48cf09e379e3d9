namespace Headless.Checks.Gpu;

/// <summary>Holds measured figures against the committed ones.</summary>
internal sealed class TableComparison(IReadOnlyList<FigureRule> rules)
{
    public List<string> Findings { get; } = [];
    public List<string> Notes { get; } = [];

    public void Compare(FigureTable committed, FigureTable measured)
    {
        foreach (var key in measured.Rows.Keys.Except(committed.Rows.Keys)) Findings.Add($"{Shown(key)}: not in the table");
        foreach (var key in committed.Rows.Keys.Except(measured.Rows.Keys)) Findings.Add($"{Shown(key)}: in the table, but not compiled");
        foreach (var key in measured.Rows.Keys.Where(committed.Rows.ContainsKey))
            foreach (var rule in rules)
            {
                var (was, now) = (committed[key, rule.Column], measured[key, rule.Column]);
                if (rule.IsWorse(was, now)) (rule.Fails ? Findings : Notes).Add($"{Shown(key)}: {rule.Column} {was} -> {now}");
            }
    }

    private static string Shown(string key) => string.Join(' ', key.Split(',', StringSplitOptions.RemoveEmptyEntries));
}
