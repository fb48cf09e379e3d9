using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Draws each base camera with the overlay cameras of its stack.</summary>
public sealed class UniversalRenderPipeline : RenderPipeline
{
    public const string k_ShaderTagName = "UniversalPipeline";

    /// <summary>As the shaders' MAX_VISIBLE_LIGHTS on desktops.</summary>
    private const int VisibleLights = 256;

    private readonly RenderGraph graph = new("URPRenderGraph");
    private readonly ContextContainer frame = new();

    public UniversalRenderPipeline(UniversalRenderPipelineAsset asset)
    {
        Settings = asset;
        Shader.globalRenderPipeline = k_ShaderTagName;
    }

    public static UniversalRenderPipelineAsset? asset => GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset;
    public static float minRenderScale => 0.1f;
    public static float maxRenderScale => 2f;
    public static float maxShadowBias => 10f;
    public static int maxPerObjectLights => 8;
    public static int maxVisibleAdditionalLights => VisibleLights;

    /// <summary>Passes run by their Execute, as before the render graph and as in compatibility mode.</summary>
    internal static bool CompatibilityMode { get; set; }

    internal UniversalRenderPipelineAsset Settings { get; }

    /// <summary>Names of the passes that the last camera ran.</summary>
    internal IReadOnlyList<string> LastPasses => graph.LastRun;

    protected override void Render(ScriptableRenderContext renderContext, Camera[] cameras) => Render(renderContext, new List<Camera>(cameras));

    protected override void Render(ScriptableRenderContext renderContext, List<Camera> cameras)
    {
        BeginContextRendering(renderContext, cameras);
        GraphicsSettings.lightsUseLinearIntensity = QualitySettings.activeColorSpace == ColorSpace.Linear;
        GraphicsSettings.lightsUseColorTemperature = true;
        FrameGlobals.Set();
        foreach (Camera camera in cameras.OrderBy(c => c.depth))
        {
            if (camera.cameraType == CameraType.Game)
            {
                RenderStack(renderContext, camera);
            }
            else
            {
                Draw(renderContext, camera, camera, null, true);
            }
        }

        graph.EndFrame();
        EndContextRendering(renderContext, cameras);
    }

    protected override void Dispose(bool disposing)
    {
        graph.Cleanup();
        frame.Dispose();
        Settings.Forget();
        Blitter.Cleanup();
        Shader.globalRenderPipeline = string.Empty;
        base.Dispose(disposing);
    }

    private void RenderStack(ScriptableRenderContext context, Camera camera)
    {
        camera.TryGetComponent(out UniversalAdditionalCameraData? data);
        if (data != null && data.renderType == CameraRenderType.Overlay)
        {
            return;
        }

        EyePass.ForEach(camera, () => RenderStack(context, camera, data));
    }

    private void RenderStack(ScriptableRenderContext context, Camera camera, UniversalAdditionalCameraData? data)
    {
        List<Camera> overlays = data != null ? Overlays(camera, data) : [];
        Draw(context, camera, camera, data, overlays.Count == 0);
        foreach (Camera overlay in overlays)
        {
            Draw(context, overlay, camera, overlay.GetComponent<UniversalAdditionalCameraData>(), overlay == overlays[^1]);
        }
    }

    private static List<Camera> Overlays(Camera camera, UniversalAdditionalCameraData data)
    {
        var found = new List<Camera>();
        foreach (Camera overlay in data.cameraStack!.Where(c => c != null && c.isActiveAndEnabled))
        {
            if (overlay.TryGetComponent(out UniversalAdditionalCameraData other) && other.renderType == CameraRenderType.Overlay)
            {
                found.Add(overlay);
            }
            else
            {
                Debug.LogWarning($"Stack can only contain Overlay cameras. The camera: {overlay.name} has a type Base that is not supported. Will skip rendering.");
            }
        }

        return found;
    }

    private void Draw(ScriptableRenderContext context, Camera camera, Camera baseCamera, UniversalAdditionalCameraData? data, bool isLast)
    {
        BeginCameraRendering(context, camera);
        try
        {
            RenderSingle(context, camera, baseCamera, data, isLast);
        }
        finally
        {
            EndCameraRendering(context, camera);
        }
    }

    private void RenderSingle(ScriptableRenderContext context, Camera camera, Camera baseCamera, UniversalAdditionalCameraData? data, bool isLast)
    {
        // The component may have been added by a listener.
        ScriptableRenderer renderer = (data != null ? data.scriptableRenderer : null) ?? Settings.scriptableRenderer;
        if (!camera.TryGetCullingParameters(out ScriptableCullingParameters culling))
        {
            renderer.Finish();
            return;
        }

        frame.Dispose();
        frame.Create<UniversalResourceData>();
        UniversalCameraData cameraData = CameraSetup.Fill(frame.Create<UniversalCameraData>(), Settings, renderer, camera, baseCamera, data, isLast);
        var legacy = new CameraData(frame);
        var commands = new CommandBuffer { name = camera.name };
        try
        {
            renderer.PreCull(legacy);
            renderer.SetupCullingParameters(ref culling, ref legacy);
            CullingResults results = context.Cull(ref culling);
            LightSetup.Fill(frame, Settings, renderer, results);
            var rendering = new RenderingData(frame);
            renderer.AddFeaturePasses(ref rendering);
            graph.BeginRecording(new RenderGraphParameters
            {
                executionName = camera.name,
                commandBuffer = commands,
                scriptableRenderContext = context,
                currentFrameIndex = Time.frameCount,
            });
            renderer.Record(graph, context, frame);
            graph.EndRecordingAndExecute();
            context.ExecuteCommandBuffer(commands);
            context.Submit();
        }
        finally
        {
            commands.Release();
            renderer.Finish();
        }
    }
}
