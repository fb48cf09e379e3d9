using Headless.Checks.Api;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>package.json, its changelog entry, its samples and the files a package ships.</summary>
internal sealed partial class PackageManifestCheck(string packageRoot)
{
    private const int MaxPathLength = 140;
    private static readonly string[] requiredFiles = ["package.json", "README.md", "CHANGELOG.md", "LICENSE.md", "Third Party Notices.md", "Documentation~/index.md"];

    public CheckReport Run()
    {
        var report = new CheckReport($"manifest of {Path.GetFileName(packageRoot)}");
        foreach (var file in requiredFiles)
            if (!File.Exists(Path.Combine(packageRoot, file))) report.Findings.Add($"{file} is missing");
        if (!File.Exists(Path.Combine(packageRoot, "package.json"))) return report;
        using var json = JsonDocument.Parse(File.ReadAllText(Path.Combine(packageRoot, "package.json")));
        var root = json.RootElement;
        var version = Text(root, "version");
        if (Text(root, "name") != Path.GetFileName(packageRoot)) report.Findings.Add("package.json: 'name' differs from the folder's name");
        if (!SemanticVersion().IsMatch(version)) report.Findings.Add($"package.json: version '{version}' is not a semantic version");
        if (Text(root, "unity") != UnityLine.All[0].Name) report.Findings.Add($"package.json: 'unity' must be the oldest line, {UnityLine.All[0]}");
        foreach (var key in new[] { "displayName", "description", "license" })
            if (Text(root, key).Length == 0) report.Findings.Add($"package.json: '{key}' is missing");
        CheckChangelog(version, report);
        var samples = CheckSamples(root, report);
        var files = CheckPaths(report);
        report.Figures = $"version {version}, {samples} samples, {files} files, paths at most {MaxPathLength} characters";
        return report;
    }

    /// <summary>The newest entry is that of the version, with its day or the word unreleased.</summary>
    private void CheckChangelog(string version, CheckReport report)
    {
        var file = Path.Combine(packageRoot, "CHANGELOG.md");
        if (!File.Exists(file)) return;
        var newest = ChangelogEntry().Match(File.ReadAllText(file));
        if (newest.Groups[1].Value != version) report.Findings.Add($"CHANGELOG.md begins with no entry '## [{version}] - ' and a day or 'unreleased'");
    }

    private int CheckSamples(JsonElement root, CheckReport report)
    {
        var listed = root.TryGetProperty("samples", out var samples) ? samples.EnumerateArray().Select(s => Text(s, "path")).ToList() : [];
        foreach (var path in listed)
            if (!Directory.Exists(Path.Combine(packageRoot, path))) report.Findings.Add($"package.json lists the sample '{path}', which does not exist");
        var folder = Path.Combine(packageRoot, "Samples~");
        if (Directory.Exists(folder))
            foreach (var sample in Directory.GetDirectories(folder).Select(d => "Samples~/" + Path.GetFileName(d)))
                if (!listed.Contains(sample)) report.Findings.Add($"the sample '{sample}' is not listed in package.json");
        return listed.Count;
    }

    private int CheckPaths(CheckReport report)
    {
        var files = Directory.GetFiles(packageRoot, "*", SearchOption.AllDirectories);
        foreach (var file in files)
        {
            var relative = Path.Combine(Path.GetFileName(packageRoot), Path.GetRelativePath(packageRoot, file));
            if (relative.Length > MaxPathLength) report.Findings.Add($"{relative}: {relative.Length} characters, at most {MaxPathLength}");
            if (relative.IndexOfAny(['\\', ':', '*', '?', '"', '<', '>', '|']) >= 0) report.Findings.Add($"{relative}: a character that Windows forbids");
        }
        return files.Length;
    }

    private static string Text(JsonElement element, string key) =>
        element.TryGetProperty(key, out var value) && value.ValueKind == JsonValueKind.String ? value.GetString()! : "";

    [GeneratedRegex(@"^## \[([^\]]*)\] - (?:\d{4}-\d\d-\d\d|unreleased)$", RegexOptions.Multiline)] private static partial Regex ChangelogEntry();
    [GeneratedRegex(@"^\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?$")] private static partial Regex SemanticVersion();
}
