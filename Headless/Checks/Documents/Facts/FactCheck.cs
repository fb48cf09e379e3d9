namespace Headless.Checks.Documents.Facts;

/// <summary>Every fact that a document marks is what its source says; with update it is written so.</summary>
internal sealed class FactCheck(ProjectPackages packages, FactSources sources)
{
    public CheckReport Run(bool update)
    {
        var report = new CheckReport("facts");
        var names = new HashSet<string>();
        int facts = 0, written = 0;
        foreach (var document in MarkdownFile.FindAll(packages))
        {
            if (FactMarker.Unpaired(document.Text) > 0) report.Findings.Add($"{document.Shown}: a fact begins or ends without its other half");
            report.Findings.AddRange(FactMarker.AtLineStart(document.Text).Select(i => $"{document.Shown}({document.LineOf(i)}): a fact begins the line, which is then shown as it is written"));
            foreach (var marker in FactMarker.In(document.Text))
            {
                facts++;
                names.Add(marker.Name);
                if (Problem(marker, update) is { } problem) report.Findings.Add($"{document.Shown}({document.LineOf(marker.Index)}): {problem}");
            }
            if (!update) continue;
            var text = FactMarker.Update(document.Text, Known);
            if (text == document.Text) continue;
            File.WriteAllText(document.Path, text);
            written++;
        }
        report.Figures = $"{facts} facts, {names.Count} of them different" + (update ? $"; {written} documents written" : "");
        return report;
    }

    private string? Problem(FactMarker marker, bool update)
    {
        try
        {
            var value = FactMarker.Written(sources.Find(marker.Name));
            return update || value == marker.Value ? null : $"{marker.Name} is {Shown(value)} and not {Shown(marker.Value)}; ./run check --only docs --update writes it";
        }
        catch (UnknownFactException e)
        {
            return $"there is no fact '{marker.Name}': {e.Message}";
        }
    }

    private string? Known(string name)
    {
        try
        {
            return sources.Find(name);
        }
        catch (UnknownFactException)
        {
            return null;
        }
    }

    private static string Shown(string value) => value.Contains('\n') ? "another table" : $"'{value}'";
}
