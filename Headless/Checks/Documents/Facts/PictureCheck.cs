using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// Each picture that is recorded is the file that was made, with the moments and the size that its script has now, and a page that shows it takes its caption from the record.
/// </summary>
internal sealed partial class PictureCheck(ProjectPackages packages)
{
    private const string Script = "Headless/Docs/pictures.sh";

    public CheckReport Run()
    {
        var report = new CheckReport("pictures");
        var records = PictureRecord.Folders(packages).SelectMany(PictureRecord.Read).ToList();
        foreach (var record in records.Where(r => !r.IsThisFile)) report.Findings.Add($"{Path.GetRelativePath(packages.Project, record.File)} is not the picture that {PictureRecord.TableName} records; its script makes both");
        foreach (var group in records.GroupBy(r => r.Name).Where(g => g.Count() > 1)) report.Findings.Add($"{PictureRecord.TableName} has '{group.Key}' twice");
        foreach (var (name, sample, size, moments) in Scripted()) CheckScript(records, name, sample, size, moments, report);
        foreach (var folder in PictureRecord.Folders(packages)) CheckFolder(folder, records, report);
        var captions = 0;
        foreach (var document in MarkdownFile.FindAll(packages).Where(d => !d.Shown.EndsWith("CHANGELOG.md", StringComparison.Ordinal))) captions += CheckPage(document, records, report);
        report.Figures = $"{records.Count} are recorded, pages show them {captions} times";
        return report;
    }

    // Lines of the script's table: name, sample, size of a tile, tiles, moments.
    private IEnumerable<(string Name, string Sample, string Size, string Moments)> Scripted()
    {
        var script = Path.Combine(packages.Project, Script);
        if (!File.Exists(script)) yield break;
        foreach (Match line in Line().Matches(Here().Match(File.ReadAllText(script)).Groups[1].Value))
            yield return (line.Groups["name"].Value, line.Groups["sample"].Value, line.Groups["size"].Value, line.Groups["moments"].Value.Trim());
    }

    private static void CheckScript(List<PictureRecord> records, string name, string sample, string size, string moments, CheckReport report)
    {
        if (records.Find(r => r.Name == name) is not { } record) report.Findings.Add($"{Script} makes '{name}', which {PictureRecord.TableName} does not record: run it");
        else if (record.Sample != sample || string.Join(' ', record.Moments) != moments || !record.Command.Contains($"--size {size}", StringComparison.Ordinal))
            report.Findings.Add($"{Script} makes '{name}' of {sample} at {moments} s in {size}, its record says {record.Sample}, {record.Times}, `{record.Command}`: run it");
    }

    private static void CheckFolder(string folder, List<PictureRecord> records, CheckReport report)
    {
        foreach (var file in Directory.GetFiles(folder).Where(f => Path.GetExtension(f) is ".png" or ".webp" or ".gif" && !records.Exists(r => r.File == f)))
            report.Findings.Add($"{PictureRecord.TableName} does not record {Path.GetFileName(file)}");
    }

    private static int CheckPage(MarkdownFile document, List<PictureRecord> records, CheckReport report)
    {
        var shown = 0;
        var text = FactMarker.Blank(document.Text);
        foreach (Match picture in Picture().Matches(text))
        {
            if (records.Find(r => Path.GetFileName(r.File) == Path.GetFileName(picture.Groups["file"].Value)) is not { } record) continue;
            shown++;
            var said = Times().Match(picture.Groups["alt"].Value);
            if (said.Success && record.Moments.Length > 0 && said.Groups[1].Value != record.Times)
                report.Findings.Add($"{document.Shown}({document.LineOf(picture.Index)}): the picture shows {record.Times}, its text says {said.Groups[1].Value}");
        }
        foreach (Match command in Command().Matches(text))
            if (records.Find(r => Same(r.Command, command.Groups[1].Value)) is { } record && document.Text.Contains(Path.GetFileName(record.File), StringComparison.Ordinal))
                report.Findings.Add($"{document.Shown}({document.LineOf(command.Index)}): a typed caption; <!--fact:picture:{record.Name}--> has it");
        return shown;
    }

    private static bool Same(string a, string b) => Space().Replace(a, " ") == Space().Replace(b, " ");

    [GeneratedRegex(@"<< 'PICTURES'\n([\s\S]*?)^PICTURES", RegexOptions.Multiline)] private static partial Regex Here();
    [GeneratedRegex(@"^(?<name>[\w-]+) (?<sample>\w+) (?<size>\d+x\d+) \d+x\d+(?<moments>(?: [\d.]+)+)", RegexOptions.Multiline)] private static partial Regex Line();
    [GeneratedRegex(@"!\[(?<alt>[^\]]*)\]\((?<file>[^()\s]+)\)")] private static partial Regex Picture();
    [GeneratedRegex(@"\bafter ((?:[\d.]+, )*(?:[\d.]+ and )?[\d.]+ s)\b")] private static partial Regex Times();
    [GeneratedRegex(@"`(\./run play[^`]*)`")] private static partial Regex Command();
    [GeneratedRegex(@"\s+")] private static partial Regex Space();
}
