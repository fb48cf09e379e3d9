using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What surfaces mirror outside all probes: RenderSettings.customReflectionTexture, or the sky drawn into a small cubemap.</summary>
/// <remarks>
/// Its mip levels are box-filtered, where Unity convolves with the lobes of rough surfaces. Drawn when first asked for and again when another
/// skybox is set, as Unity's is when a scene's light is made; later changes of the material or the sun do not show.
/// </remarks>
internal static class DefaultReflection
{
    // Forward and up of the six faces in Direct3D's order: the first row of a face lies in the direction of its up.
    private static readonly (Vector3 Forward, Vector3 Up)[] Faces =
    [
        (Vector3.right, Vector3.up), (Vector3.left, Vector3.up),
        (Vector3.up, Vector3.back), (Vector3.down, Vector3.forward),
        (Vector3.forward, Vector3.up), (Vector3.back, Vector3.up),
    ];

    private static RenderTexture? sky;
    private static Material? drawn;

    public static Texture Texture => Custom ?? Sky();

    public static Vector4 HdrDecode => new(RenderSettings.reflectionIntensity, 1f, 0f, 0f);

    private static Texture? Custom =>
        RenderSettings.defaultReflectionMode == DefaultReflectionMode.Custom
        && RenderSettings.customReflectionTexture is { } custom && custom != null && custom.dimension == TextureDimension.Cube
            ? custom
            : null;

    public static void Reset() => (sky, drawn) = (null, null);

    private static RenderTexture Sky()
    {
        int resolution = Mathf.Clamp(RenderSettings.defaultReflectionResolution, ReflectionProbe.minBakedCubemapResolution, ReflectionProbe.maxBakedCubemapResolution);
        if (sky == null || sky.width != resolution || !ReferenceEquals(drawn, RenderSettings.skybox))
        {
            sky?.Release();
            sky = new RenderTexture(new RenderTextureDescriptor(resolution, resolution, RenderTextureFormat.ARGBHalf)
            {
                dimension = TextureDimension.Cube,
                useMipMap = true,
            })
            {
                name = "Sky reflection",
                filterMode = FilterMode.Trilinear,
                hideFlags = HideFlags.HideAndDontSave,
            };
            drawn = RenderSettings.skybox;
            Draw(sky);
        }

        return sky;
    }

    // The sun of the built-in sky is left out: shaders add its highlight from the light itself.
    private static Vector4 Sun() =>
        LightList.Main is { } sun && !ReferenceEquals(RenderSettings.skybox, BuiltinResources.DefaultSkybox) ? -sun.transform.forward : default;

    private static void Draw(RenderTexture cube)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        DrawTarget? before = TargetState.Current;
        (Matrix4x4 view, Matrix4x4 projection) = (ViewState.View, ViewState.Projection);
        (Vector4 sun, Vector4 ortho) = (sheet.GetVector(BuiltinNames.LightPosition), sheet.GetVector(BuiltinNames.OrthoParams));
        sheet.SetVector(BuiltinNames.LightPosition, Sun());
        sheet.SetVector(BuiltinNames.OrthoParams, default);
        for (int face = 0; face < Faces.Length; face++)
        {
            // Not flipped: the first row of a face is its top.
            TargetState.Set(new DrawTarget { Colors = [cube.DrawTarget!], Resolves = [null], Slice = face });
            Matrix4x4 toFace = Matrix4x4.Rotate(Quaternion.Inverse(Quaternion.LookRotation(Faces[face].Forward, Faces[face].Up)));
            ViewState.Set(Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * toFace, Matrix4x4.Perspective(90f, 1f, 0.1f, 10f));
            TargetState.Clear(true, false, Color.black, 0f);
            Engine.Sky.Draw();
        }

        TargetState.Set(before);
        ViewState.Set(view, projection);
        sheet.SetVector(BuiltinNames.LightPosition, sun);
        sheet.SetVector(BuiltinNames.OrthoParams, ortho);
        cube.GenerateMips();
    }
}
