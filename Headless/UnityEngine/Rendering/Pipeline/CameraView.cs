using UnityEngine;

namespace Headless.Engine;

/// <summary>What a camera sees with, as it was at one time.</summary>
internal readonly record struct CameraView(
    Vector3 Position, Matrix4x4 View, Matrix4x4 Projection, float Near, float Far, bool Orthographic, float OrthographicSize, float Aspect)
{
    public Vector3 Forward => -(Vector3)View.GetRow(2);

    public static CameraView Of(Camera camera) => Stereo.EyeOf(camera) is { } eye ? Of(camera, eye) : OfMiddle(camera);

    public static CameraView Of(Camera camera, Camera.StereoscopicEye eye)
    {
        Matrix4x4 view = camera.GetStereoViewMatrix(eye);
        return OfMiddle(camera) with { Position = view.inverse.GetColumn(3), View = view, Projection = camera.GetStereoProjectionMatrix(eye) };
    }

    private static CameraView OfMiddle(Camera camera) => new(
        camera.transform.position, camera.worldToCameraMatrix, camera.projectionMatrix, camera.nearClipPlane, camera.farClipPlane,
        camera.orthographic, camera.orthographicSize, camera.aspect);
}
