using UnityEngine;

namespace Headless.Engine;

/// <summary>Sets the matrices that shaders see.</summary>
internal static class ViewState
{
    public static Matrix4x4 View { get; private set; } = Matrix4x4.identity;
    public static Matrix4x4 Projection { get; private set; } = Matrix4x4.identity;

    /// <summary>
    /// The camera's own variables and _ScreenParams are those of the target and the matrices that are set, as in Built-in; in a scriptable
    /// pipeline they are its cameras'.
    /// </summary>
    public static bool FollowsTarget { get; set; } = true;

    /// <summary>Unity's projection (z from -1 to 1) turned into the device's: z from 1 (near) to 0, upside down for textures.</summary>
    public static Matrix4x4 Gpu(Matrix4x4 projection, bool flipped)
    {
        if (flipped)
        {
            projection.SetRow(1, -projection.GetRow(1));
        }

        projection.SetRow(2, (projection.GetRow(3) - projection.GetRow(2)) * 0.5f);
        return projection;
    }

    public static void Set(Matrix4x4 view, Matrix4x4 projection)
    {
        (View, Projection) = (view, projection);
        Apply();
    }

    /// <summary>Writes the matrices anew, for a target that may be upside down.</summary>
    public static void Apply()
    {
        bool flipped = TargetState.Current?.Flipped ?? false;
        PropertySheet sheet = GlobalProperties.Sheet;
        Matrix4x4 gpu = Gpu(Projection, flipped);
        sheet.SetMatrix(BuiltinNames.MatrixV, View);
        sheet.SetMatrix(BuiltinNames.MatrixInvV, View.inverse);
        sheet.SetMatrix(BuiltinNames.Projection, gpu);
        sheet.SetMatrix(BuiltinNames.MatrixVP, gpu * View);
        Vector4 parameters = sheet.GetVector(BuiltinNames.ProjectionParams);
        parameters.x = flipped ? -1f : 1f;
        sheet.SetVector(BuiltinNames.ProjectionParams, parameters);

        EyeViews.Apply(flipped);
        if (FollowsTarget)
        {
            ApplyCamera();
        }
    }

    /// <summary>Writes what describes the camera, whatever is drawn.</summary>
    public static void ApplyCamera()
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetMatrix(BuiltinNames.CameraProjection, Projection);
        sheet.SetMatrix(BuiltinNames.CameraInvProjection, Projection.inverse);

        // unity_WorldToCamera looks along +z, unlike the view matrix.
        Matrix4x4 worldToCamera = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * View;
        sheet.SetMatrix(BuiltinNames.WorldToCamera, worldToCamera);
        sheet.SetMatrix(BuiltinNames.CameraToWorld, worldToCamera.inverse);

        if (TargetState.Current is { } target)
        {
            SetScreen(target.Width, target.Height);
        }
    }

    public static void SetScreen(float width, float height) =>
        GlobalProperties.Sheet.SetVector(BuiltinNames.ScreenParams, new Vector4(width, height, 1f + (1f / width), 1f + (1f / height)));

    /// <summary>Depth ranges as UnityCG's LinearEyeDepth and Linear01Depth expect them with reversed depth.</summary>
    public static void SetDepthRange(float near, float far)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        float x = (far / near) - 1f;
        sheet.SetVector(BuiltinNames.ZBufferParams, new Vector4(x, 1f, x / far, 1f / far));
        float flip = sheet.GetVector(BuiltinNames.ProjectionParams).x;
        sheet.SetVector(BuiltinNames.ProjectionParams, new Vector4(flip == 0f ? 1f : flip, near, far, 1f / far));
    }
}
