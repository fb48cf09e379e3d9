using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>Draws frames by recording commands into a context.</summary>
public abstract class RenderPipeline
{
    public bool disposed { get; private set; }

    public static bool SupportsRenderRequest<RequestData>(Camera camera, RequestData data) =>
        RenderPipelineManager.Prepared is { } pipeline && pipeline.IsRenderRequestSupported(camera, data);

    public static void SubmitRenderRequest<RequestData>(Camera camera, RequestData data)
    {
        if (camera == null)
        {
            throw new ArgumentNullException(nameof(camera));
        }

        if (RenderPipelineManager.Prepared is { } pipeline)
        {
            pipeline.Run(context => pipeline.ProcessRenderRequests(context, camera, data));
        }
        else
        {
            Debug.LogWarning("Trying to submit a render request with no render pipeline active.");
        }
    }

    internal void Render(List<Camera> cameras) => Run(context => Render(context, cameras));

    internal void End()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
        disposed = true;
    }

    protected static void BeginFrameRendering(ScriptableRenderContext context, Camera[] cameras) =>
        RenderPipelineManager.BeginContext(context, [.. cameras]);

    protected static void BeginContextRendering(ScriptableRenderContext context, List<Camera> cameras) =>
        RenderPipelineManager.BeginContext(context, cameras);

    protected static void BeginCameraRendering(ScriptableRenderContext context, Camera camera) =>
        RenderPipelineManager.BeginCamera(context, camera);

    protected static void EndFrameRendering(ScriptableRenderContext context, Camera[] cameras) =>
        RenderPipelineManager.EndContext(context, [.. cameras]);

    protected static void EndContextRendering(ScriptableRenderContext context, List<Camera> cameras) =>
        RenderPipelineManager.EndContext(context, cameras);

    protected static void EndCameraRendering(ScriptableRenderContext context, Camera camera) =>
        RenderPipelineManager.EndCamera(context, camera);

    protected virtual bool IsRenderRequestSupported<RequestData>(Camera camera, RequestData data) => false;

    protected virtual void ProcessRenderRequests<RequestData>(ScriptableRenderContext context, Camera camera, RequestData renderRequest)
    {
    }

    protected abstract void Render(ScriptableRenderContext context, Camera[] cameras);

    protected virtual void Render(ScriptableRenderContext context, List<Camera> cameras) => Render(context, cameras.ToArray());

    protected virtual void Dispose(bool disposing)
    {
    }

    private void Run(Action<ScriptableRenderContext> record)
    {
        ObjectDisposedException.ThrowIf(disposed, this);
        PipelineRunner.Run(record);
    }

    public class StandardRequest
    {
        public RenderTexture? destination;
        public int mipLevel;
        public CubemapFace face = CubemapFace.Unknown;
        public int slice;
    }
}
