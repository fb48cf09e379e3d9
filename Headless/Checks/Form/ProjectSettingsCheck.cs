using System.Text.Json.Nodes;
using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>ProjectSettings has every file that Unity 2022.3 writes, so that opening the project leaves the tree as it was.</summary>
internal sealed partial class ProjectSettingsCheck(ProjectPackages packages)
{
    /// <summary>Class and class id of each .asset.</summary>
    private static readonly Dictionary<string, (string Class, int Id)> assets = new()
    {
        ["AudioManager"] = ("AudioManager", 11),
        ["ClusterInputManager"] = ("ClusterInputManager", 236),
        ["DynamicsManager"] = ("PhysicsManager", 55),
        ["EditorBuildSettings"] = ("EditorBuildSettings", 1045),
        ["EditorSettings"] = ("EditorSettings", 159),
        ["GraphicsSettings"] = ("GraphicsSettings", 30),
        ["InputManager"] = ("InputManager", 13),
        ["MemorySettings"] = ("MemorySettings", 387306366),
        ["NavMeshAreas"] = ("NavMeshProjectSettings", 126),
        ["PackageManagerSettings"] = ("MonoBehaviour", 114),
        ["Physics2DSettings"] = ("Physics2DSettings", 19),
        ["PresetManager"] = ("PresetManager", 1386491679),
        ["ProjectSettings"] = ("PlayerSettings", 129),
        ["QualitySettings"] = ("QualitySettings", 47),
        ["TagManager"] = ("TagManager", 78),
        ["TimeManager"] = ("TimeManager", 5),
        ["URPProjectSettings"] = ("MonoBehaviour", 114),
        ["UnityConnectSettings"] = ("UnityConnectSettings", 310),
        ["VFXManager"] = ("VFXManager", 937362698),
        ["VersionControlSettings"] = ("VersionControlSettings", 890905787),
    };

    private static readonly string[] others = ["ProjectVersion.txt", "SceneTemplateSettings.json"];

    public CheckReport Run()
    {
        var report = new CheckReport("project settings");
        var folder = Path.Combine(packages.Project, "ProjectSettings");
        foreach (var (name, expected) in assets)
        {
            var file = Path.Combine(folder, name + ".asset");
            if (!File.Exists(file)) { report.Findings.Add($"ProjectSettings/{name}.asset is missing: Unity would add it"); continue; }
            var head = Head().Match(File.ReadAllText(file));
            if (!head.Success || head.Groups[1].Value != expected.Id.ToString() || head.Groups[2].Value != expected.Class)
                report.Findings.Add($"ProjectSettings/{name}.asset does not begin with an object '!u!{expected.Id}' of class {expected.Class}");
        }
        foreach (var name in others)
            if (!File.Exists(Path.Combine(folder, name))) report.Findings.Add($"ProjectSettings/{name} is missing: Unity would add it");
        CheckLock(report);
        CheckVersions(report);
        report.Figures = $"{assets.Count + others.Length} files, locked packages that the manifests ask for, one version of all packages";
        return report;
    }

    /// <summary>What manifest.json and the packages ask for is what packages-lock.json holds, the packages themselves included.</summary>
    private void CheckLock(CheckReport report)
    {
        var file = Path.Combine(packages.Folder, "packages-lock.json");
        if (!File.Exists(file)) { report.Findings.Add("Packages/packages-lock.json is missing: Unity would add it"); return; }
        var locked = Read(file)["dependencies"]!.AsObject();
        var manifests = packages.All.ToDictionary(p => Path.GetFileName(p), p => Path.Combine(p, "package.json")).Where(p => File.Exists(p.Value)).ToDictionary();
        var project = Path.Combine(packages.Folder, "manifest.json");
        if (File.Exists(project)) CheckDependencies("manifest.json", Read(project), locked, manifests, report);
        foreach (var (name, manifest) in manifests)
        {
            if ((string?)locked[name]?["version"] != "file:" + name) report.Findings.Add($"packages-lock.json does not have {name} as file:{name}");
            CheckDependencies(name + "/package.json", Read(manifest), locked, manifests, report);
            if (!JsonNode.DeepEquals(locked[name]?["dependencies"] ?? new JsonObject(), Read(manifest)["dependencies"] ?? new JsonObject()))
                report.Findings.Add($"packages-lock.json has other dependencies of {name} than its package.json");
        }
    }

    private void CheckVersions(CheckReport report)
    {
        var versions = packages.All.Select(p => Path.Combine(p, "package.json")).Where(File.Exists)
            .Select(f => (Name: Path.GetFileName(Path.GetDirectoryName(f)!), Version: (string?)Read(f)["version"])).ToList();
        foreach (var (name, version) in versions)
            if (version != versions[0].Version) report.Findings.Add($"{name} has version {version}, {versions[0].Name} {versions[0].Version}");
    }

    private static void CheckDependencies(string asking, JsonNode manifest, JsonObject locked, IReadOnlyDictionary<string, string> embedded, CheckReport report)
    {
        foreach (var (name, version) in manifest["dependencies"]?.AsObject() ?? [])
        {
            // Of a package that the project embeds, whatever version is asked for, Unity takes the folder.
            var has = (string?)(embedded.TryGetValue(name, out var own) ? Read(own)["version"] : locked[name]?["version"]);
            if (has != (string?)version) report.Findings.Add($"{asking} asks for {name} {version}, {(own is null ? "packages-lock.json" : "the project")} has {has ?? "none"}");
        }
    }

    private static JsonNode Read(string file) => JsonNode.Parse(File.ReadAllText(file))!;

    [GeneratedRegex(@"\A%YAML 1\.1\n%TAG !u! tag:unity3d\.com,2011:\n--- !u!(\d+) &1\n(\w+):\n  ")] private static partial Regex Head();
}
