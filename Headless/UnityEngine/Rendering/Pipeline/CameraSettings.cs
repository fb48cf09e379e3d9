using UnityEngine;

namespace Headless.Engine;

/// <summary>The camera's variables in shaders.</summary>
internal static class CameraSettings
{
    public static void Apply(Camera camera)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        Vector3 position = camera.transform.position;
        sheet.SetVector(BuiltinNames.WorldSpaceCameraPos, new Vector4(position.x, position.y, position.z, 0f));
        ViewState.Set(camera.worldToCameraMatrix, camera.projectionMatrix);
        ViewState.SetDepthRange(camera.nearClipPlane, camera.farClipPlane);
        float height = camera.orthographicSize;
        sheet.SetVector(BuiltinNames.OrthoParams, new Vector4(height * camera.aspect, height, 0f, camera.orthographic ? 1f : 0f));
    }
}
