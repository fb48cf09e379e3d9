using Headless.Engine;
using Headless.Importers.Yaml;
using UnityEngine;

namespace Headless.Importers.Project;

/// <summary>What the ProjectSettings folder says; a file that is missing leaves Unity's defaults.</summary>
internal static class ProjectSettingsReader
{
    /// <param name="report">Takes what the stand-in does otherwise than the project asks.</param>
    public static void Apply(string projectRoot, Action<string> report)
    {
        string folder = Path.Combine(projectRoot, "ProjectSettings");
        if (Read(folder, "ProjectSettings.asset") is { } player)
        {
            EngineState.ProductName = player.Text("productName", EngineState.ProductName);
            EngineState.CompanyName = player.Text("companyName", EngineState.CompanyName);
            if (player.Int("m_ActiveColorSpace", 1) == 0)
                report("ProjectSettings: the colour space is Gamma; pictures are made in Linear here. Set Player > Other Settings > Color Space to Linear for the same look.");
        }
        if (Read(folder, "TimeManager.asset") is { } time)
        {
            Time.fixedDeltaTime = time.Float("Fixed Timestep", 0.02f);
            Time.maximumDeltaTime = time.Float("Maximum Allowed Timestep", 1f / 3);
            Time.timeScale = time.Float("m_TimeScale", 1);
        }
        if (Read(folder, "TagManager.asset") is { } tags)
        {
            foreach (YamlNode tag in tags.List("tags")) TagManager.AddTag(tag.ToString()!);
            IReadOnlyList<YamlNode> layers = tags.List("layers");
            for (int i = 0; i < Math.Min(32, layers.Count); i++) TagManager.SetLayer(i, layers[i].ToString()!);
        }
    }

    /// <summary>Enabled scenes of the build list, in order.</summary>
    public static IReadOnlyList<string> ScenesInBuild(string projectRoot) =>
        Read(Path.Combine(projectRoot, "ProjectSettings"), "EditorBuildSettings.asset")?.List("m_Scenes").OfType<YamlMap>()
            .Where(s => s.Bool("enabled")).Select(s => s.Text("path")).ToArray() ?? [];

    private static YamlMap? Read(string folder, string file)
    {
        string path = Path.Combine(folder, file);
        return File.Exists(path) ? UnityYaml.ReadDocuments(path).FirstOrDefault()?.Body : null;
    }
}
