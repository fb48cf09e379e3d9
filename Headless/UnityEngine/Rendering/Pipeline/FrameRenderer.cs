using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Draws a frame: every enabled camera in order of depth, then forgets the frame's queued draws.</summary>
internal static class FrameRenderer
{
    private static readonly ForwardRenderer Forward = new();

    /// <summary>Where the camera's picture ends up, while image effects run; null otherwise.</summary>
    public static DrawTarget? FinalTarget { get; set; }

    public static void RenderFrame()
    {
        if (!GraphicsDevice.IsReady)
        {
            return;
        }

        ShaderTime.Apply();
        RenderPipeline? pipeline = RenderPipelineManager.Prepared;
        List<Camera> cameras = [.. CameraList.Ordered.Where(c => c.isActiveAndEnabled && HasPixels(c))];
        if (pipeline is not null)
        {
            RenderAll(pipeline, cameras);
        }
        else if (GraphicsSettings.currentRenderPipeline is null)
        {
            cameras.ForEach(RenderBuiltin);
        }

        DrawQueue.Clear();
    }

    public static void Render(Camera camera)
    {
        if (!HasPixels(camera))
        {
            return;
        }

        if (RenderPipelineManager.Prepared is { } pipeline)
        {
            RenderAll(pipeline, [camera]);
        }
        else if (GraphicsSettings.currentRenderPipeline is null)
        {
            RenderBuiltin(camera);
        }
    }

    public static void Reset()
    {
        FinalTarget = null;
        Forward.Reset();
        EyeTextures.Reset();
        PipelineRunner.Reset();
        StateOverrides.Reset();
        DefaultReflection.Reset();
    }

    private static bool HasPixels(Camera camera) => camera.pixelWidth > 0 && camera.pixelHeight > 0;

    private static void RenderAll(RenderPipeline pipeline, List<Camera> cameras)
    {
        if (cameras.Count == 0)
        {
            return;
        }

        int timer = GpuTimings.Begin("RenderPipeline.Render");
        pipeline.Render(cameras);
        GpuTimings.End(timer);
    }

    private static void RenderBuiltin(Camera camera)
    {
        Camera? before = Camera.current;
        DrawTarget? targetBefore = TargetState.Current;
        Camera.current = camera;
        int timer = GpuTimings.Begin("Camera.Render");
        try
        {
            Forward.Render(camera);
        }
        finally
        {
            TargetState.Set(targetBefore);
            GpuTimings.End(timer);
            Camera.current = before;
            FinalTarget = null;
        }
    }
}
