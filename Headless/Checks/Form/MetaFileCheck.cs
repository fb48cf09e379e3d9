using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>Every asset and folder that Unity imports has a .meta with a unique GUID, no .meta is left over, and no
/// scene, prefab, material, asset or project setting refers to a GUID that nothing has.</summary>
internal sealed partial class MetaFileCheck(ProjectPackages packages)
{
    private static readonly string[] builtInGuids = ["0000000000000000e000000000000000", "0000000000000000f000000000000000", "00000000000000000000000000000000"];
    private static readonly string[] referencing = [".unity", ".prefab", ".asset", ".mat", ".meta"];

    public CheckReport Run()
    {
        var report = new CheckReport("meta files and references");
        var owners = new Dictionary<string, string>();
        foreach (var root in packages.All.Prepend(Path.Combine(packages.Project, "Assets")))
            if (Directory.Exists(root)) CheckFolder(root, owners, report);
        var references = CheckReferences(owners, report);
        report.Figures = $"{owners.Count} assets and folders with unique GUIDs, {references} references resolved";
        return report;
    }

    private void CheckFolder(string folder, Dictionary<string, string> owners, CheckReport report)
    {
        // Samples~ and Documentation~ have no .meta of their own; what a sample holds keeps its .meta for the import.
        var ignored = Path.GetFileName(folder).EndsWith('~');
        if (ignored && Path.GetFileName(folder) != "Samples~") return;
        foreach (var entry in Directory.GetFileSystemEntries(folder).Order())
        {
            var name = Path.GetFileName(entry);
            if (name.StartsWith('.')) continue;
            var isFolder = Directory.Exists(entry);
            if (isFolder && name.EndsWith('~')) { CheckFolder(entry, owners, report); continue; }
            if (name.EndsWith(".meta", StringComparison.Ordinal))
            {
                var asset = entry[..^5];
                if (!File.Exists(asset) && !Directory.Exists(asset)) report.Findings.Add($"{Shown(entry)} belongs to nothing");
                continue;
            }
            CheckMeta(entry, owners, report);
            if (isFolder) CheckFolder(entry, owners, report);
        }
    }

    private void CheckMeta(string asset, Dictionary<string, string> owners, CheckReport report)
    {
        var meta = asset + ".meta";
        if (!File.Exists(meta)) { report.Findings.Add($"{Shown(asset)} has no .meta"); return; }
        var match = MetaGuid().Match(File.ReadAllText(meta));
        if (!match.Success) { report.Findings.Add($"{Shown(meta)} has no GUID of 32 lower-case hexadecimal digits"); return; }
        if (!owners.TryAdd(match.Groups[1].Value, asset)) report.Findings.Add($"{Shown(asset)} and {Shown(owners[match.Groups[1].Value])} have the same GUID");
    }

    private int CheckReferences(Dictionary<string, string> owners, CheckReport report)
    {
        var count = 0;
        var settings = Path.Combine(packages.Project, "ProjectSettings");
        var files = owners.Values.Concat(owners.Values.Select(v => v + ".meta")).Concat(Directory.Exists(settings) ? Directory.GetFiles(settings) : []);
        foreach (var file in files.Where(f => referencing.Contains(Path.GetExtension(f)) && File.Exists(f)))
            foreach (Match match in Reference().Matches(File.ReadAllText(file)))
            {
                count++;
                var guid = match.Groups[1].Value;
                if (!owners.ContainsKey(guid) && !builtInGuids.Contains(guid) && !UnityPackageAssets.Has(guid)) report.Findings.Add($"{Shown(file)} refers to {guid}, which no asset has");
            }
        return count;
    }

    private string Shown(string path) => Path.GetRelativePath(packages.Project, path);

    [GeneratedRegex(@"^guid: ([0-9a-f]{32})\s*$", RegexOptions.Multiline)] private static partial Regex MetaGuid();
    [GeneratedRegex(@"fileID: -?\d+, guid: ([0-9a-f]{32})")] private static partial Regex Reference();
}
