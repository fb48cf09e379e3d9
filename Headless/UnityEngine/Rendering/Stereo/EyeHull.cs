using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>One view that holds those of both eyes, for culling.</summary>
internal static class EyeHull
{
    private static readonly Vector3[] Corners = [.. Enumerable.Range(0, 8).Select(i => new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1))];

    public static Matrix4x4 Of(Camera camera)
    {
        Matrix4x4 view = camera.worldToCameraMatrix;
        Vector3[] corners = [.. Points(camera, Camera.StereoscopicEye.Left, view), .. Points(camera, Camera.StereoscopicEye.Right, view)];

        // Seen from behind the eyes, where the narrower of both sides of the view meet: e.g. 11 mm for eyes 22 mm apart that see 90 degrees.
        Matrix4x4 projection = camera.projectionMatrix;
        float back = camera.orthographic ? 0f : camera.stereoSeparation * projection.m00;
        float near = corners.Min(c => -c.z) + back;
        float far = corners.Max(c => -c.z) + back;
        float Slope(Vector3 corner, float side) => camera.orthographic ? side : side / (back - corner.z) * near;
        float left = corners.Min(c => Slope(c, c.x)), right = corners.Max(c => Slope(c, c.x));
        float bottom = corners.Min(c => Slope(c, c.y)), top = corners.Max(c => Slope(c, c.y));
        Matrix4x4 hull = camera.orthographic ? Matrix4x4.Ortho(left, right, bottom, top, near, far) : Matrix4x4.Frustum(left, right, bottom, top, near, far);
        return hull * Matrix4x4.Translate(new Vector3(0f, 0f, -back)) * view;
    }

    private static Vector3[] Points(Camera camera, Camera.StereoscopicEye eye, Matrix4x4 view)
    {
        Matrix4x4 toCamera = view * (camera.GetStereoProjectionMatrix(eye) * camera.GetStereoViewMatrix(eye)).inverse;
        return [.. Corners.Select(c => toCamera.MultiplyPoint(c))];
    }
}
