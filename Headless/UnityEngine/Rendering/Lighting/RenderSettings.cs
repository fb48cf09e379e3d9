using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class RenderSettings : Object
{
    private static SphericalHarmonicsL2? customProbe;
    private static Material? ownSkybox;
    private static bool hasOwnSkybox;

    private RenderSettings()
    {
    }

    public static bool fog { get; set; }
    public static FogMode fogMode { get; set; } = FogMode.ExponentialSquared;
    public static Color fogColor { get; set; } = new(0.5f, 0.5f, 0.5f, 1f);
    public static float fogDensity { get; set; } = 0.01f;
    public static float fogStartDistance { get; set; }
    public static float fogEndDistance { get; set; } = 300f;
    public static AmbientMode ambientMode { get; set; } = AmbientMode.Skybox;
    public static Color ambientSkyColor { get; set; } = new(0.212f, 0.227f, 0.259f, 1f);
    public static Color ambientEquatorColor { get; set; } = new(0.114f, 0.125f, 0.133f, 1f);
    public static Color ambientGroundColor { get; set; } = new(0.047f, 0.043f, 0.035f, 1f);
    public static float ambientIntensity { get; set; } = 1f;
    public static Color subtractiveShadowColor { get; set; } = new(0.42f, 0.478f, 0.627f, 1f);
    public static Light? sun { get; set; }
    public static float reflectionIntensity { get; set; } = 1f;
    public static int reflectionBounces { get; set; } = 1;
    public static DefaultReflectionMode defaultReflectionMode { get; set; }
    public static Texture? customReflectionTexture { get; set; }
    public static int defaultReflectionResolution { get; set; } = 128;
    public static float haloStrength { get; set; } = 0.5f;
    public static float flareStrength { get; set; } = 1f;
    public static float flareFadeSpeed { get; set; } = 3f;

    /// <summary>A new scene has Default-Skybox; null for none, where cameras clear to their background color.</summary>
    public static Material? skybox
    {
        get => hasOwnSkybox ? ownSkybox : BuiltinResources.DefaultSkybox;
        set => (ownSkybox, hasOwnSkybox) = (value, true);
    }

    /// <summary>Follows from mode, colors and intensity, but in custom mode is what was set.</summary>
    public static SphericalHarmonicsL2 ambientProbe
    {
        get => ambientMode == AmbientMode.Custom && customProbe is { } probe ? probe : AmbientLight.Probe();
        set => customProbe = value;
    }

    public static Color ambientLight
    {
        get => ambientSkyColor;
        set => ambientSkyColor = value;
    }

    /// <summary>Unity's defaults, for a new scene.</summary>
    internal static void Reset()
    {
        fog = false;
        fogMode = FogMode.ExponentialSquared;
        fogColor = new Color(0.5f, 0.5f, 0.5f, 1f);
        fogDensity = 0.01f;
        fogStartDistance = 0f;
        fogEndDistance = 300f;
        ambientMode = AmbientMode.Skybox;
        ambientSkyColor = new Color(0.212f, 0.227f, 0.259f, 1f);
        ambientEquatorColor = new Color(0.114f, 0.125f, 0.133f, 1f);
        ambientGroundColor = new Color(0.047f, 0.043f, 0.035f, 1f);
        ambientIntensity = 1f;
        (ownSkybox, hasOwnSkybox, sun, customProbe) = (null, false, null, null);
        (defaultReflectionMode, customReflectionTexture) = (DefaultReflectionMode.Skybox, null);
        (reflectionIntensity, defaultReflectionResolution, reflectionBounces) = (1f, 128, 1);
    }
}
