using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>
/// Scenes of the samples and of Assets are lit without a bake: Unity 6 leaves the ambient light of the sky black where a scene has no
/// lighting data. Their sun is assigned, so that nobody searches for it.
/// </summary>
internal sealed partial class SceneLightCheck(ProjectPackages packages)
{
    private const string Skybox = "0", Directional = "1", None = "{fileID: 0}";

    public CheckReport Run()
    {
        var report = new CheckReport("light of scenes");
        var scenes = packages.SceneFolders().SelectMany(f => Directory.GetFiles(f, "*.unity", SearchOption.AllDirectories)).Order().ToList();
        foreach (var file in scenes)
        {
            var text = File.ReadAllText(file);
            var name = Path.GetRelativePath(packages.Project, file);
            var baked = Value(text, "m_LightingDataAsset") is not (None or "");
            if (!baked && Value(text, "m_AmbientMode") is Skybox or "")
                report.Findings.Add($"{name}: its ambient light is the sky's (m_AmbientMode {Skybox}) and it has no lighting data");
            var sun = SunId().Match(text).Groups[1].Value;
            var light = new Regex($@"^--- !u!108 &{sun}\b[^\0]*?^  m_Type: (\d+)", RegexOptions.Multiline).Match(text);
            if (sun is "" or "0" || !light.Success) report.Findings.Add($"{name}: it has no sun (m_Sun)");
            else if (light.Groups[1].Value != Directional) report.Findings.Add($"{name}: its sun is not a directional light");
        }
        report.Figures = $"{scenes.Count} scenes with ambient colours or lighting data, and a sun";
        return report;
    }

    private static string Value(string text, string field) => new Regex($@"^  {field}: (.*?)\s*$", RegexOptions.Multiline).Match(text).Groups[1].Value;

    [GeneratedRegex(@"^  m_Sun: \{fileID: (-?\d+)", RegexOptions.Multiline)] private static partial Regex SunId();
}
