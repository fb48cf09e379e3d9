namespace UnityEngine.Rendering;

public sealed class GraphicsSettings : Object
{
    private GraphicsSettings()
    {
    }

    /// <summary>Null: the built-in pipeline draws.</summary>
    public static RenderPipelineAsset? currentRenderPipeline => null;

    public static RenderPipelineAsset? defaultRenderPipeline { get; set; }
    public static bool lightsUseLinearIntensity { get; set; }
    public static bool lightsUseColorTemperature { get; set; }
    public static bool useScriptableRenderPipelineBatching { get; set; }
}
