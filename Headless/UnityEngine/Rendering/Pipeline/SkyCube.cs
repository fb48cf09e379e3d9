using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The sky as a cubemap with mip levels, for what mirrors it.</summary>
/// <remarks>Its mip levels are box-filtered, where Unity convolves with the lobes of rough surfaces.</remarks>
internal static class SkyCube
{
    public static RenderTexture New(int resolution, string name)
    {
        int edge = Mathf.Clamp(resolution, ReflectionProbe.minBakedCubemapResolution, ReflectionProbe.maxBakedCubemapResolution);
        return new RenderTexture(new RenderTextureDescriptor(edge, edge, RenderTextureFormat.ARGBHalf) { dimension = TextureDimension.Cube, useMipMap = true })
        {
            name = name,
            filterMode = FilterMode.Trilinear,
            hideFlags = HideFlags.HideAndDontSave,
        };
    }

    /// <summary>Draws RenderSettings.skybox over a background; where there is no skybox, the background is left.</summary>
    public static void Draw(RenderTexture cube, Color background, bool skybox)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        DrawTarget? before = TargetState.Current;
        (Matrix4x4 view, Matrix4x4 projection) = (ViewState.View, ViewState.Projection);
        (Vector4 light, Vector4 ortho) = (sheet.GetVector(BuiltinNames.LightPosition), sheet.GetVector(BuiltinNames.OrthoParams));
        sheet.SetVector(BuiltinNames.LightPosition, Sun());
        sheet.SetVector(BuiltinNames.OrthoParams, default);
        for (int face = 0; face < CubeFaces.Count; face++)
        {
            // Not flipped: the first row of a face is its top.
            TargetState.Set(new DrawTarget { Colors = [cube.DrawTarget!], Resolves = [null], Slice = face });
            TargetState.Clear(true, false, background.linear, 0f);
            ViewState.Set(Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * CubeFaces.ToFace(face), Matrix4x4.Perspective(90f, 1f, 0.1f, 10f));
            if (skybox)
            {
                Sky.Draw();
            }

            TargetState.Finish();
        }

        TargetState.Set(before);
        ViewState.Set(view, projection);
        sheet.SetVector(BuiltinNames.LightPosition, light);
        sheet.SetVector(BuiltinNames.OrthoParams, ortho);
        cube.GenerateMips();
    }

    // The sun of the built-in sky is left out: shaders add its highlight from the light itself.
    private static Vector4 Sun() =>
        LightList.Main is { } sun && !ReferenceEquals(RenderSettings.skybox, BuiltinResources.DefaultSkybox) ? -sun.transform.forward : default;
}
