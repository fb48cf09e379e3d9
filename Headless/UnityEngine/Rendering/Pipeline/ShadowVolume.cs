using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The box in light space that the shadow map covers.</summary>
/// <remarks>
/// Its width is that of a sphere round all casters, rounded up in steps, and its centre moves by whole texels: shadows
/// do not shimmer while things move inside it. Scenes larger than the shadow distance use a sphere before the camera.
/// </remarks>
internal readonly record struct ShadowVolume(Matrix4x4 View, Matrix4x4 Projection, float Width, float Depth)
{
    public static ShadowVolume Around(List<DrawRequest> casters, Camera camera, Transform light, int texels)
    {
        Bounds all = casters[0].Bounds;
        foreach (DrawRequest caster in casters)
        {
            all.Encapsulate(caster.Bounds);
        }

        Vector3 center = all.center;
        float radius = Mathf.Max(0.01f, all.extents.magnitude);
        float limit = Mathf.Min(QualitySettings.shadowDistance, camera.farClipPlane);
        if (radius > limit)
        {
            radius = limit * 0.5f;
            center = camera.transform.position + (camera.transform.forward * radius);
        }

        // Steps of a quarter octave.
        radius = Mathf.Pow(2f, Mathf.Ceil(Mathf.Log(radius, 2f) * 4f) / 4f);
        float texel = radius * 2f / texels;
        Matrix4x4 toLight = Matrix4x4.Rotate(Quaternion.Inverse(light.rotation));
        Vector3 local = toLight.MultiplyPoint3x4(center);
        local.x = Mathf.Round(local.x / texel) * texel;
        local.y = Mathf.Round(local.y / texel) * texel;

        float near = float.MaxValue;
        float far = float.MinValue;
        foreach (DrawRequest caster in casters)
        {
            Bounds bounds = BoundsTransform.ToWorld(caster.Bounds, toLight);
            near = Mathf.Min(near, bounds.min.z);
            far = Mathf.Max(far, bounds.max.z);
        }

        near -= texel * 4f;
        far = Mathf.Max(far, local.z + radius) + (texel * 4f);
        Matrix4x4 view = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.Translate(new Vector3(-local.x, -local.y, -near)) * toLight;
        Matrix4x4 projection = Matrix4x4.Ortho(-radius, radius, -radius, radius, 0f, far - near);
        return new ShadowVolume(view, projection, radius * 2f, far - near);
    }

    /// <summary>Half its diagonal across the light and along it.</summary>
    public float Radius => 0.5f * Mathf.Sqrt((2f * Width * Width) + (Depth * Depth));

    /// <summary>In world space.</summary>
    public Vector3 Center => View.inverse.MultiplyPoint3x4(new Vector3(0f, 0f, -0.5f * Depth));

    /// <summary>World to texture coordinates and reversed depth, with a bias towards the light in metres.</summary>
    public Matrix4x4 WorldToShadow(float bias)
    {
        Matrix4x4 matrix = ViewState.Gpu(Projection, false) * View;
        matrix.SetRow(0, (matrix.GetRow(0) + matrix.GetRow(3)) * 0.5f);
        matrix.SetRow(1, (matrix.GetRow(1) + matrix.GetRow(3)) * 0.5f);
        matrix.SetRow(2, matrix.GetRow(2) + (matrix.GetRow(3) * (bias / Depth)));
        return matrix;
    }
}
