using Headless.Importers.Assets;
using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Project;

/// <summary>The render pipeline of a project: that of its quality level, or else that of its graphics settings.</summary>
internal static class PipelineSettings
{
    public static void Apply(string projectRoot, ProjectAssets assets)
    {
        YamlMap? graphics = ProjectSettingsReader.Read(projectRoot, "GraphicsSettings.asset");
        GraphicsSettings.lightsUseLinearIntensity = graphics?.Bool("m_LightsUseLinearIntensity") ?? false;
        GraphicsSettings.lightsUseColorTemperature = graphics?.Bool("m_LightsUseColorTemperature") ?? false;
        GraphicsSettings.Open(() => Asset(graphics, "m_CustomRenderPipeline", assets));
        YamlMap? quality = ProjectSettingsReader.Read(projectRoot, "QualitySettings.asset");
        YamlMap? level = quality?.Maps("m_QualitySettings").ElementAtOrDefault(quality.Int("m_CurrentQuality", 0));
        QualitySettings.Open(() => Asset(level, "customRenderPipeline", assets));
    }

    private static RenderPipelineAsset? Asset(YamlMap? settings, string key, ProjectAssets assets)
    {
        if (settings?[key] is not { } node) return null;
        var reference = FileReference.Read(node, new SourceScope(node.Place.File));
        return (RenderPipelineAsset?)assets.Resolve(reference, typeof(RenderPipelineAsset), $"{node.Place}: {key}");
    }
}
