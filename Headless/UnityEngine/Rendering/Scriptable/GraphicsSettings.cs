using System;

namespace UnityEngine.Rendering;

public sealed class GraphicsSettings : Object
{
    private static Lazy<RenderPipelineAsset?> defaultAsset = new((RenderPipelineAsset?)null);

    private GraphicsSettings()
    {
    }

    /// <summary>The quality level's, or else the default one; null: the built-in pipeline draws.</summary>
    public static RenderPipelineAsset? currentRenderPipeline =>
        QualitySettings.renderPipeline is { } asset && asset != null ? asset : defaultRenderPipeline;

    public static RenderPipelineAsset? defaultRenderPipeline
    {
        get => defaultAsset.Value is { } asset && asset != null ? asset : null;
        set => RenderPipelineManager.Change(() => defaultAsset = new(value));
    }

    /// <summary>On: a light's color is made linear before the intensity multiplies it, and color temperatures count.</summary>
    public static bool lightsUseLinearIntensity { get; set; }

    public static bool lightsUseColorTemperature { get; set; }
    public static bool useScriptableRenderPipelineBatching { get; set; }

    /// <summary>The asset that the project's settings name, loaded when it is first asked for.</summary>
    internal static void Open(Func<RenderPipelineAsset?> asset) => defaultAsset = new(asset);
}
