using UnityEngine;

namespace Headless.Engine;

/// <summary>Material.SetPass followed by Graphics.Draw...Now, into the active render texture or the camera's target.</summary>
internal static class ImmediateDrawing
{
    private static Material? material;
    private static int pass;

    public static bool SetPass(Material value, int passIndex)
    {
        (material, pass) = (value, passIndex);
        return value != null && passIndex >= 0 && passIndex < value.passCount;
    }

    public static void Draw(DrawGeometry geometry, in Matrix4x4 matrix)
    {
        if (material == null)
        {
            Debug.LogError("Graphics.Draw...Now needs Material.SetPass before it.");
            return;
        }

        DrawTarget? before = TargetState.Current;
        if (RenderTexture.active is { } active && active != null)
        {
            TargetState.Set(DrawTarget.Of(active));
            ViewState.Apply();
        }
        else if (before is null)
        {
            TargetState.Set(DrawTarget.Screen);
            ViewState.Apply();
        }

        Drawer.Draw(material, pass, null, geometry, matrix);
        if (TargetState.Current != before)
        {
            TargetState.Set(before);
        }
    }
}
