using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What ForwardAdd passes read of a light: its falloff with distance, and the round spot of spot lights.</summary>
internal static class LightTextures
{
    private const int FalloffSize = 1024;
    private const int SpotSize = 128;

    // Where a spot begins to fade, as a share of its radius; the edge of Unity's own spot is not documented.
    private const float SoftFrom = 0.72f;

    private static Texture2D? falloff;
    private static Texture2D? spot;

    /// <summary>Light at the square of the distance over the range.</summary>
    public static Texture2D Falloff => falloff = falloff != null ? falloff : MakeFalloff();

    /// <summary>Light over the square that the cone fits into, in alpha.</summary>
    public static Texture2D Spot => spot = spot != null ? spot : MakeSpot();

    /// <param name="distance">As a share of the light's range.</param>
    public static float At(float distance) =>
        Mathf.Clamp01((1f - distance) * 5f) / (1f + (25f * distance * distance));

    public static void Reset() => (falloff, spot) = (null, null);

    private static Texture2D MakeFalloff()
    {
        var colors = new Color[FalloffSize];
        for (int i = 0; i < FalloffSize; i++)
        {
            // From 1 in the middle of the first texel to 0 in that of the last.
            float value = At(Mathf.Sqrt(i / (FalloffSize - 1f)));
            colors[i] = new Color(value, value, value, value);
        }

        return Make("Light falloff", FalloffSize, 1, GraphicsFormat.R16G16B16A16_SFloat, colors);
    }

    private static Texture2D MakeSpot()
    {
        var colors = new Color[SpotSize * SpotSize];
        for (int i = 0; i < colors.Length; i++)
        {
            float x = (((i % SpotSize) + 0.5f) / SpotSize * 2f) - 1f;
            float y = (((i / SpotSize) + 0.5f) / SpotSize * 2f) - 1f;
            bool border = i % SpotSize is 0 or SpotSize - 1 || i / SpotSize is 0 or SpotSize - 1;
            float value = border ? 0f : Mathf.SmoothStep(1f, 0f, Mathf.InverseLerp(SoftFrom, 1f, Mathf.Sqrt((x * x) + (y * y))));
            colors[i] = new Color(1f, 1f, 1f, value);
        }

        return Make("Spot", SpotSize, SpotSize, GraphicsFormat.R8G8B8A8_UNorm, colors);
    }

    private static Texture2D Make(string name, int width, int height, GraphicsFormat format, Color[] colors)
    {
        var texture = new Texture2D(width, height, format, TextureCreationFlags.None)
        {
            name = name,
            hideFlags = HideFlags.HideAndDontSave,
            wrapMode = TextureWrapMode.Clamp,
            filterMode = FilterMode.Bilinear,
        };
        texture.SetPixels(colors);
        texture.Apply(false, true);
        return texture;
    }
}
