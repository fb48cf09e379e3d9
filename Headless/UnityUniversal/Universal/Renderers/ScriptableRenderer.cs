using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Draws cameras with its own passes and those that features and scripts enqueue.</summary>
public abstract class ScriptableRenderer : IDisposable
{
    private readonly List<ScriptableRenderPass> queue = [];
    private readonly List<ScriptableRendererFeature> features = [];

    protected ScriptableRenderer(ScriptableRendererData data)
    {
        foreach (ScriptableRendererFeature feature in data.rendererFeatures.Where(f => f != null))
        {
            feature.Create();
            features.Add(feature);
        }
    }

    /// <summary>In compatibility mode, while a pass executes.</summary>
    public RTHandle? cameraColorTargetHandle { get; private set; }

    /// <summary>In compatibility mode, while a pass executes.</summary>
    public RTHandle? cameraDepthTargetHandle { get; private set; }

    protected internal List<ScriptableRendererFeature> rendererFeatures => features;
    protected internal List<ScriptableRenderPass> activeRenderPassQueue => queue;

    /// <summary>For the camera that is drawn next; the queue is empty after each camera.</summary>
    public void EnqueuePass(ScriptableRenderPass pass) => queue.Add(pass);

    public virtual void SetupCullingParameters(ref ScriptableCullingParameters cullingParameters, ref CameraData cameraData)
    {
    }

    public virtual int SupportedCameraStackingTypes() => 0;

    public bool SupportsCameraStackingType(CameraRenderType cameraRenderType) => (SupportedCameraStackingTypes() & (1 << (int)cameraRenderType)) != 0;

    public void Dispose()
    {
        features.ForEach(f => f.Dispose());
        features.Clear();
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    internal abstract void Record(RenderGraph graph, ScriptableRenderContext context, ContextContainer frame);

    internal abstract bool DrawsIntoTexture(UniversalCameraData camera);

    internal virtual void Describe(UniversalRenderingData rendering)
    {
    }

    internal void PreCull(in CameraData camera)
    {
        foreach (ScriptableRendererFeature feature in features.Where(f => f.isActive))
        {
            feature.OnCameraPreCull(this, camera);
        }
    }

    internal void AddFeaturePasses(ref RenderingData rendering)
    {
        foreach (ScriptableRendererFeature feature in features.Where(f => f.isActive))
        {
            feature.AddRenderPasses(this, ref rendering);
        }
    }

    internal void Finish() => queue.Clear();

    protected virtual void Dispose(bool disposing)
    {
    }

    /// <summary>Records the enqueued passes of an event up to another, that one left out.</summary>
    private protected void RecordEvents(RenderGraph graph, ContextContainer frame, RenderPassEvent from, RenderPassEvent before)
    {
        foreach (ScriptableRenderPass pass in queue.Where(p => p.renderPassEvent >= from && p.renderPassEvent < before).OrderBy(p => p.renderPassEvent).ToList())
        {
            if (UniversalRenderPipeline.CompatibilityMode)
            {
                RecordExecute(graph, frame, pass);
            }
            else
            {
                pass.RecordRenderGraph(graph, frame);
            }
        }
    }

    private void RecordExecute(RenderGraph graph, ContextContainer frame, ScriptableRenderPass pass)
    {
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass(pass.GetType().Name, out ExecuteData data);
        (data.Pass, data.Frame, data.Color, data.Depth, data.Renderer) = (pass, frame, resources.activeColorTexture, resources.activeDepthTexture, this);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.UseTexture(data.Color, AccessFlags.ReadWrite);
        builder.UseTexture(data.Depth, AccessFlags.ReadWrite);
        builder.SetRenderFunc(static (ExecuteData d, UnsafeGraphContext context) => d.Renderer.Execute(d, context));
    }

    private void Execute(ExecuteData data, UnsafeGraphContext graphContext)
    {
        var rendering = new RenderingData(data.Frame);
        CommandBuffer commands = CommandBufferHelpers.GetNativeCommandBuffer(graphContext.cmd);
        (cameraColorTargetHandle, cameraDepthTargetHandle) = (data.Color, data.Depth);
        data.Pass.OnCameraSetup(commands, ref rendering);
        data.Pass.Configure(commands, rendering.cameraData.cameraTargetDescriptor);
        RTHandle color = data.Pass.colorAttachmentHandle ?? cameraColorTargetHandle!;
        commands.SetRenderTarget(color, data.Pass.depthAttachmentHandle ?? cameraDepthTargetHandle!);
        if (data.Pass.clearFlag != ClearFlag.None)
        {
            commands.ClearRenderTarget((data.Pass.clearFlag & ClearFlag.Depth) != 0, (data.Pass.clearFlag & ClearFlag.Color) != 0, data.Pass.clearColor);
        }

        graphContext.cmd.Between(context =>
        {
            var copy = new RenderingData(data.Frame);
            data.Pass.Execute(context, ref copy);
        });
        data.Pass.OnCameraCleanup(commands);
        (cameraColorTargetHandle, cameraDepthTargetHandle) = (null, null);
    }

    private sealed class ExecuteData
    {
        public ScriptableRenderer Renderer { get; set; } = null!;
        public ScriptableRenderPass Pass { get; set; } = null!;
        public ContextContainer Frame { get; set; } = null!;
        public TextureHandle Color { get; set; }
        public TextureHandle Depth { get; set; }
    }
}
