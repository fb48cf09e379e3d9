using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What surfaces mirror outside all probes: RenderSettings.customReflectionTexture, or the sky drawn into a small cubemap.</summary>
/// <remarks>
/// Drawn when first asked for and again when another skybox is set, as Unity's is when a scene's light is made; later changes of the
/// material or the sun do not show.
/// </remarks>
internal static class DefaultReflection
{
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
            sky = SkyCube.New(resolution, "Sky reflection");
            drawn = RenderSettings.skybox;
            SkyCube.Draw(sky, Color.black, true);
        }

        return sky;
    }
}
