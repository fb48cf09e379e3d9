using Headless.Engine;

namespace UnityEngine;

public sealed class GL
{
    public static bool invertCulling
    {
        get => Drawer.InvertCulling;
        set => Drawer.InvertCulling = value;
    }

    public static Matrix4x4 modelview => ViewState.View;

    public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 proj, bool renderIntoTexture) => ViewState.Gpu(proj, renderIntoTexture);

    public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor) => Clear(clearDepth, clearColor, backgroundColor, 1f);

    public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor, float depth)
    {
        DrawTarget? before = TargetState.Current;
        if (RenderTexture.active is { } active && active != null)
        {
            TargetState.Set(DrawTarget.Of(active));
        }
        else if (before is null)
        {
            TargetState.Set(DrawTarget.Screen);
        }

        TargetState.Clear(clearColor, clearDepth, backgroundColor, 1f - depth);
        if (TargetState.Current != before)
        {
            TargetState.Set(before);
        }
    }

    public static void Flush() => GraphicsDevice.Device.Flush();
}
