using System.Globalization;
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
        if (Read(projectRoot, "ProjectSettings.asset") is { } player)
        {
            EngineState.ProductName = player.Text("productName", EngineState.ProductName);
            EngineState.CompanyName = player.Text("companyName", EngineState.CompanyName);
            if (player.Int("m_ActiveColorSpace", 1) == 0)
                report("ProjectSettings: the colour space is Gamma; pictures are made in Linear here. Set Player > Other Settings > Color Space to Linear for the same look.");
        }
        EngineState.EnterPlayModeOptions = Read(projectRoot, "EditorSettings.asset") is { } editor && editor.Bool("m_EnterPlayModeOptionsEnabled")
            ? editor.Int("m_EnterPlayModeOptions", 0) : null;
        if (Read(projectRoot, "TimeManager.asset") is { } time)
        {
            Time.fixedDeltaTime = Within(FixedTimestep(time), "Fixed Timestep", 0.02f, 0.0001f, 10);
            Time.maximumDeltaTime = Within(time, "Maximum Allowed Timestep", 1f / 3, 0.0001f, 1000);
            Time.timeScale = Within(time, "m_TimeScale", 1, 0, 100);
        }
        if (Read(projectRoot, "TagManager.asset") is { } tags)
        {
            foreach (string tag in tags.Texts("tags")) TagManager.AddTag(tag);
            foreach (var (layer, i) in tags.Texts("layers").Take(32).Select((layer, i) => (layer, i))) TagManager.SetLayer(i, layer);
        }
    }

    /// <summary>Enabled scenes of the build list, in order.</summary>
    public static IReadOnlyList<string> ScenesInBuild(string projectRoot) =>
        Read(projectRoot, "EditorBuildSettings.asset")?.Maps("m_Scenes")
            .Where(s => s.Bool("enabled")).Select(s => s.Text("path")).ToArray() ?? [];

    /// <summary>The settings of one file; null where it is missing.</summary>
    public static YamlMap? Read(string projectRoot, string file)
    {
        string path = Path.Combine(projectRoot, "ProjectSettings", file);
        return File.Exists(path) ? UnityYaml.ReadDocuments(path).FirstOrDefault()?.Body : null;
    }

    /// <summary>Unity 6 writes a fraction: m_Count m_Denominator / m_Numerator, 2822399 · 1 / 141120000 for 0.02 s.</summary>
    private static YamlMap FixedTimestep(YamlMap time)
    {
        if (time["Fixed Timestep"] is not YamlMap { Count: > 0 } fraction) return time;
        YamlMap rate = fraction.Map("m_Rate") ?? new YamlMap(fraction.Place);
        double seconds = (double)fraction.Long("m_Count") * rate.Long("m_Denominator", 1) / rate.Long("m_Numerator", 1);
        var plain = new YamlMap(fraction.Place);
        plain.Set("Fixed Timestep", new YamlScalar(((float)seconds).ToString("R", CultureInfo.InvariantCulture), fraction.Place));
        return plain;
    }

    private static float Within(YamlMap map, string key, float absent, float least, float most)
    {
        float value = map.Float(key, absent);
        if (value >= least && value <= most) return value;
        throw ImportException.At((map[key] ?? map).Place.ToString(), FormattableString.Invariant($"'{key}' must be from {least} to {most}, found {value}."));
    }
}
