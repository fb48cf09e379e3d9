using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering;

/// <summary>Makes the pipeline of the current asset when a frame needs it, and tells scripts of frames, cameras and changes.</summary>
public static class RenderPipelineManager
{
    private static RenderPipelineAsset? preparedAsset;
    private static Type? lastType;
    private static bool stale;

    public static event Action<ScriptableRenderContext, List<Camera>>? beginContextRendering;
    public static event Action<ScriptableRenderContext, List<Camera>>? endContextRendering;
    public static event Action<ScriptableRenderContext, Camera[]>? beginFrameRendering;
    public static event Action<ScriptableRenderContext, Camera[]>? endFrameRendering;
    public static event Action<ScriptableRenderContext, Camera>? beginCameraRendering;
    public static event Action<ScriptableRenderContext, Camera>? endCameraRendering;

    /// <summary>After the first frame's pipeline has another class than the last one's; the built-in pipeline counts as a class.</summary>
    public static event Action? activeRenderPipelineTypeChanged;

    /// <summary>As soon as a setting names another asset; from and to.</summary>
    public static event Action<RenderPipelineAsset?, RenderPipelineAsset?>? activeRenderPipelineAssetChanged;

    public static event Action? activeRenderPipelineCreated;

    /// <summary>Before the pipeline is disposed of.</summary>
    public static event Action? activeRenderPipelineDisposed;

    public static RenderPipeline? currentPipeline { get; private set; }

    /// <summary>False from a change of the asset until the next frame.</summary>
    public static bool pipelineSwitchCompleted => ReferenceEquals(preparedAsset, GraphicsSettings.currentRenderPipeline);

    /// <summary>The pipeline of the current asset, made anew where it must; null for the built-in one.</summary>
    internal static RenderPipeline? Prepared
    {
        get
        {
            RenderPipelineAsset? asset = GraphicsSettings.currentRenderPipeline;
            if (stale || !ReferenceEquals(asset, preparedAsset))
            {
                Clean();
                (preparedAsset, stale) = (asset, false);
            }

            if (asset is not null && currentPipeline is null)
            {
                Make(asset);
            }

            Type? type = currentPipeline?.GetType();
            if (type != lastType)
            {
                lastType = type;
                activeRenderPipelineTypeChanged?.Invoke();
            }

            return currentPipeline;
        }
    }

    /// <summary>Carries out a change of the settings, and tells of it where another asset is the current one afterwards.</summary>
    internal static void Change(Action change)
    {
        RenderPipelineAsset? before = GraphicsSettings.currentRenderPipeline;
        change();
        RenderPipelineAsset? after = GraphicsSettings.currentRenderPipeline;
        if (!ReferenceEquals(before, after))
        {
            activeRenderPipelineAssetChanged?.Invoke(before, after);
        }
    }

    internal static void Recreate(RenderPipelineAsset asset) => stale |= ReferenceEquals(asset, preparedAsset);

    /// <summary>The pipeline ends with the play; the settings stay.</summary>
    internal static void Reset()
    {
        Clean();
        (preparedAsset, lastType, stale) = (null, null, false);
    }

    internal static void BeginContext(ScriptableRenderContext context, List<Camera> cameras)
    {
        beginFrameRendering?.Invoke(context, [.. cameras]);
        beginContextRendering?.Invoke(context, cameras);
    }

    internal static void EndContext(ScriptableRenderContext context, List<Camera> cameras)
    {
        endFrameRendering?.Invoke(context, [.. cameras]);
        endContextRendering?.Invoke(context, cameras);
    }

    internal static void BeginCamera(ScriptableRenderContext context, Camera camera) => beginCameraRendering?.Invoke(context, camera);

    internal static void EndCamera(ScriptableRenderContext context, Camera camera) => endCameraRendering?.Invoke(context, camera);

    private static void Make(RenderPipelineAsset asset)
    {
        Shader.globalRenderPipeline = asset.renderPipelineShaderTag;
        try
        {
            currentPipeline = asset.Create();
        }
        catch (Exception problem)
        {
            Debug.LogException(problem, asset);
        }

        if (currentPipeline is not null)
        {
            activeRenderPipelineCreated?.Invoke();
        }
    }

    private static void Clean()
    {
        if (currentPipeline is not { } pipeline)
        {
            return;
        }

        activeRenderPipelineDisposed?.Invoke();
        currentPipeline = null;
        pipeline.End();
        Shader.globalRenderPipeline = string.Empty;
    }
}
