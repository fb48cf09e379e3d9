using Headless.Engine;

namespace UnityEngine;

public sealed partial class Camera
{
    private Matrix4x4? projectionOverride;
    private Matrix4x4? viewOverride;
    private Matrix4x4? cullingOverride;

    public Matrix4x4 projectionMatrix
    {
        get => projectionOverride ?? DefaultProjection;
        set => projectionOverride = value;
    }

    public Matrix4x4 nonJitteredProjectionMatrix
    {
        get => projectionMatrix;
        set => projectionMatrix = value;
    }

    /// <summary>Looks along -z, as in OpenGL.</summary>
    public Matrix4x4 worldToCameraMatrix
    {
        get => viewOverride
            ?? Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one).inverse;
        set => viewOverride = value;
    }

    public Matrix4x4 cameraToWorldMatrix => worldToCameraMatrix.inverse;

    public Matrix4x4 cullingMatrix
    {
        get => cullingOverride ?? (stereoEnabled ? EyeHull.Of(this) : projectionMatrix * worldToCameraMatrix);
        set => cullingOverride = value;
    }

    public Matrix4x4 previousViewProjectionMatrix => projectionMatrix * worldToCameraMatrix;

    private Matrix4x4 DefaultProjection => orthographic
        ? Matrix4x4.Ortho(-orthographicSize * aspect, orthographicSize * aspect, -orthographicSize, orthographicSize, nearClipPlane, farClipPlane)
        : Matrix4x4.Perspective(fieldOfView, aspect, nearClipPlane, farClipPlane);

    public static float HorizontalToVerticalFieldOfView(float horizontalFieldOfView, float aspectRatio) =>
        2f * Mathf.Atan(Mathf.Tan(horizontalFieldOfView * Mathf.Deg2Rad * 0.5f) / aspectRatio) * Mathf.Rad2Deg;

    public static float VerticalToHorizontalFieldOfView(float verticalFieldOfView, float aspectRatio) =>
        2f * Mathf.Atan(Mathf.Tan(verticalFieldOfView * Mathf.Deg2Rad * 0.5f) * aspectRatio) * Mathf.Rad2Deg;

    public void ResetProjectionMatrix() => projectionOverride = null;

    public void ResetWorldToCameraMatrix() => viewOverride = null;

    public void ResetCullingMatrix() => cullingOverride = null;

    public Vector3 WorldToViewportPoint(Vector3 position)
    {
        Vector4 view = worldToCameraMatrix * new Vector4(position.x, position.y, position.z, 1f);
        Vector4 clip = projectionMatrix * view;
        return new Vector3((clip.x / clip.w * 0.5f) + 0.5f, (clip.y / clip.w * 0.5f) + 0.5f, -view.z);
    }

    public Vector3 WorldToScreenPoint(Vector3 position) => ViewportToScreenPoint(WorldToViewportPoint(position));

    public Vector3 ViewportToScreenPoint(Vector3 position)
    {
        Rect r = pixelRect;
        return new Vector3(r.x + (position.x * r.width), r.y + (position.y * r.height), position.z);
    }

    public Vector3 ScreenToViewportPoint(Vector3 position)
    {
        Rect r = pixelRect;
        return new Vector3((position.x - r.x) / r.width, (position.y - r.y) / r.height, position.z);
    }

    /// <summary>z is the distance from the camera's plane.</summary>
    public Vector3 ViewportToWorldPoint(Vector3 position)
    {
        Matrix4x4 projection = projectionMatrix;
        float x = (position.x * 2f) - 1f;
        float y = (position.y * 2f) - 1f;

        // Clip depth of a point at distance z.
        Vector4 onAxis = projection * new Vector4(0f, 0f, -position.z, 1f);
        Vector4 view = projection.inverse * new Vector4(x * onAxis.w, y * onAxis.w, onAxis.z, onAxis.w);
        return cameraToWorldMatrix.MultiplyPoint3x4(new Vector3(view.x, view.y, view.z) / view.w);
    }

    public Vector3 ScreenToWorldPoint(Vector3 position) => ViewportToWorldPoint(ScreenToViewportPoint(position));

    public Ray ViewportPointToRay(Vector3 pos)
    {
        Vector3 near = ViewportToWorldPoint(new Vector3(pos.x, pos.y, nearClipPlane));
        Vector3 far = ViewportToWorldPoint(new Vector3(pos.x, pos.y, farClipPlane));
        return new Ray(near, (far - near).normalized);
    }

    public Ray ScreenPointToRay(Vector3 pos) => ViewportPointToRay(ScreenToViewportPoint(pos));
}
