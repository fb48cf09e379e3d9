using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Player;

/// <summary>A render pipeline by name, in the place of that of the project's settings.</summary>
internal static class PipelineChoice
{
    public const string Universal = "universal", BuiltIn = "built-in";

    public static IReadOnlyList<string> Names { get; } = [Universal, BuiltIn];

    /// <param name="name">Null leaves the project's.</param>
    /// <returns>What the user should know; null where nothing.</returns>
    public static string? Apply(string? name)
    {
        if (name is null) return null;
        RenderPipelineAsset? own = name == Universal ? ProjectsUniversal() : null;
        QualitySettings.renderPipeline = null;
        GraphicsSettings.defaultRenderPipeline = own;
        if (name == BuiltIn || own is not null) return null;
        GraphicsSettings.defaultRenderPipeline = UniversalRenderPipelineAsset.Create(ScriptableObject.CreateInstance<UniversalRendererData>());
        return "--pipeline universal: the project's settings name no asset of the Universal Render Pipeline; Unity's default one draws.";
    }

    private static UniversalRenderPipelineAsset? ProjectsUniversal() =>
        QualitySettings.renderPipeline as UniversalRenderPipelineAsset ?? GraphicsSettings.defaultRenderPipeline as UniversalRenderPipelineAsset;
}
