using UnityEngine;

namespace Headless.Engine;

/// <summary>The camera's variables in shaders.</summary>
internal static class CameraSettings
{
    public static void Apply(Camera camera) => Apply(CameraView.Of(camera));

    public static void Apply(in CameraView camera)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.WorldSpaceCameraPos, new Vector4(camera.Position.x, camera.Position.y, camera.Position.z, 0f));
        ViewState.Set(camera.View, camera.Projection);
        ViewState.ApplyCamera();
        ViewState.SetDepthRange(camera.Near, camera.Far);
        float height = camera.OrthographicSize;
        sheet.SetVector(BuiltinNames.OrthoParams, new Vector4(height * camera.Aspect, height, 0f, camera.Orthographic ? 1f : 0f));
        sheet.SetVectors(BuiltinNames.CameraWorldClipPlanes, new Frustum(camera.Projection * camera.View).Planes);
    }
}
