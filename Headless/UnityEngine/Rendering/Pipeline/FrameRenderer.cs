using UnityEngine;

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
        foreach (Camera camera in CameraList.Ordered)
        {
            if (camera.isActiveAndEnabled)
            {
                Render(camera);
            }
        }

        DrawQueue.Clear();
    }

    public static void Render(Camera camera)
    {
        if (camera.pixelWidth <= 0 || camera.pixelHeight <= 0)
        {
            return;
        }

        Camera? before = Camera.current;
        DrawTarget? targetBefore = TargetState.Current;
        Camera.current = camera;
        int timer = GraphicsDevice.Recorder.BeginTimer("Camera.Render");
        try
        {
            Forward.Render(camera);
        }
        finally
        {
            TargetState.Set(targetBefore);
            GraphicsDevice.Recorder.EndTimer(timer);
            Camera.current = before;
            FinalTarget = null;
        }
    }

    public static void Reset()
    {
        FinalTarget = null;
        Forward.Reset();
        DefaultReflection.Reset();
    }
}
