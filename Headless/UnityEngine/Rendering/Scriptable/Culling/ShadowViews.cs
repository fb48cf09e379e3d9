using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Views from lights.</summary>
internal static class ShadowViews
{
    private static readonly Matrix4x4 Backwards = Matrix4x4.Scale(new Vector3(1f, 1f, -1f));

    /// <summary>A box round a cascade's sphere that reaches to the casters before it; it moves by whole texels.</summary>
    public static (Matrix4x4 View, Matrix4x4 Projection, ShadowSplitData Split) Directional(
        Light light, CascadeSlice slice, int resolution, float nearOffset, Bounds? casters)
    {
        Quaternion rotation = light.transform.rotation;
        Matrix4x4 toLight = Matrix4x4.Rotate(Quaternion.Inverse(rotation));
        float radius = slice.Radius;
        float texel = radius * 2f / Mathf.Max(1, resolution);
        Vector3 center = toLight.MultiplyPoint3x4(slice.Center);
        center.x = Mathf.Round(center.x / texel) * texel;
        center.y = Mathf.Round(center.y / texel) * texel;

        float near = center.z - radius;
        if (casters is { } bounds)
        {
            near = Mathf.Min(near, BoundsTransform.ToWorld(bounds, toLight).min.z);
        }

        near -= nearOffset;
        Matrix4x4 view = Backwards * Matrix4x4.Translate(new Vector3(-center.x, -center.y, -near)) * toLight;
        Matrix4x4 projection = Matrix4x4.Ortho(-radius, radius, -radius, radius, 0f, center.z + radius - near);
        return (view, projection, Split(projection * view, rotation * center, radius, 0f));
    }

    public static (Matrix4x4 View, Matrix4x4 Projection, ShadowSplitData Split) Spot(Light light)
    {
        Matrix4x4 view = Backwards * Matrix4x4.TRS(light.transform.position, light.transform.rotation, Vector3.one).inverse;
        return Lamp(light, view, light.spotAngle);
    }

    /// <summary>Upside down, as the faces of cubemaps lie in Direct3D.</summary>
    /// <param name="fovBias">Degrees more than the 90 of a face.</param>
    public static (Matrix4x4 View, Matrix4x4 Projection, ShadowSplitData Split) Point(Light light, CubemapFace face, float fovBias)
    {
        Matrix4x4 view = Matrix4x4.Scale(new Vector3(1f, -1f, -1f)) * CubeFaces.ToFace((int)face) * Matrix4x4.Translate(-light.transform.position);
        return Lamp(light, view, 90f + fovBias);
    }

    private static (Matrix4x4 View, Matrix4x4 Projection, ShadowSplitData Split) Lamp(Light light, Matrix4x4 view, float angle)
    {
        float near = Mathf.Max(1e-3f, light.shadowNearPlane);
        Matrix4x4 projection = Matrix4x4.Perspective(angle, 1f, near, Mathf.Max(near * 1.01f, light.range));
        return (view, projection, Split(projection * view, light.transform.position, light.range, near));
    }

    private static ShadowSplitData Split(Matrix4x4 matrix, Vector3 center, float radius, float near) => new()
    {
        cullingMatrix = matrix,
        cullingSphere = new Vector4(center.x, center.y, center.z, radius),
        cullingNearPlane = near,
        shadowCascadeBlendCullingFactor = 1f,
    };
}
