using System;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class QualitySettings : Object
{
    private static Lazy<RenderPipelineAsset?> pipelineAsset = new((RenderPipelineAsset?)null);

    private QualitySettings()
    {
    }

    public static ColorSpace activeColorSpace => ColorSpace.Linear;
    public static ColorSpace desiredColorSpace => ColorSpace.Linear;
    public static int antiAliasing { get; set; } = 4;
    public static AnisotropicFiltering anisotropicFiltering { get; set; } = AnisotropicFiltering.Enable;
    public static int vSyncCount { get; set; }
    public static int pixelLightCount { get; set; } = 4;
    public static ShadowQuality shadows { get; set; } = ShadowQuality.All;
    public static ShadowResolution shadowResolution { get; set; } = ShadowResolution.High;
    public static ShadowProjection shadowProjection { get; set; } = ShadowProjection.StableFit;
    public static float shadowDistance { get; set; } = 150f;
    public static int shadowCascades { get; set; } = 1;
    public static float lodBias { get; set; } = 2f;
    public static int maxQueuedFrames { get; set; } = 2;
    public static bool softParticles { get; set; }
    public static bool realtimeReflectionProbes { get; set; } = true;

    /// <summary>Takes the place of GraphicsSettings.defaultRenderPipeline; null for that one.</summary>
    public static RenderPipelineAsset? renderPipeline
    {
        get => pipelineAsset.Value is { } asset && asset != null ? asset : null;
        set => RenderPipelineManager.Change(() => pipelineAsset = new(value));
    }

    public static string[] names => ["Ultra"];
    public static int count => 1;

    public static int GetQualityLevel() => 0;

    /// <summary>The asset of the project's quality level, loaded when it is first asked for.</summary>
    internal static void Open(Func<RenderPipelineAsset?> asset) => pipelineAsset = new(asset);
}
