using Headless.Importers.Assets;
using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Project;

/// <summary>The render pipelines that a project's Graphics and Quality settings name; without one the Built-in pipeline draws.</summary>
internal static class RenderPipelineReader
{
    public static void Apply(string projectRoot, ProjectAssets assets)
    {
        YamlMap? quality = ProjectSettingsReader.Read(projectRoot, "QualitySettings.asset");
        YamlMap? level = quality?.Maps("m_QualitySettings").ElementAtOrDefault(quality.Int("m_CurrentQuality"));
        GraphicsSettings.defaultRenderPipeline = Find(ProjectSettingsReader.Read(projectRoot, "GraphicsSettings.asset"), "m_CustomRenderPipeline", assets);
        QualitySettings.renderPipeline = Find(level, "customRenderPipeline", assets);
    }

    private static RenderPipelineAsset? Find(YamlMap? settings, string key, ProjectAssets assets)
    {
        if (settings?[key] is not { } node) return null;
        var scope = new SourceScope(node.Place.File);
        return (RenderPipelineAsset?)assets.Resolve(FileReference.Read(node, scope), typeof(RenderPipelineAsset), $"{node.Place}: {key}");
    }
}
