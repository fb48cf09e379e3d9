using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Ambient light of the scene as colors from above, from the side and from below, and as a probe.</summary>
internal static class AmbientLight
{
    public static (Color Sky, Color Equator, Color Ground) Colors() => RenderSettings.ambientMode switch
    {
        AmbientMode.Flat => (RenderSettings.ambientSkyColor.linear, RenderSettings.ambientSkyColor.linear, RenderSettings.ambientSkyColor.linear),
        AmbientMode.Trilight => (RenderSettings.ambientSkyColor.linear, RenderSettings.ambientEquatorColor.linear, RenderSettings.ambientGroundColor.linear),
        _ => (
            Sky.AmbientUp * RenderSettings.ambientIntensity,
            Sky.AmbientLevel * RenderSettings.ambientIntensity,
            Sky.AmbientDown * RenderSettings.ambientIntensity),
    };

    /// <summary>a + b y + c y^2 through the three colors, in the basis of ShadeSH9 (y^2 = (1 - z^2 - (x^2 - y^2)) / 2).</summary>
    public static SphericalHarmonicsL2 Probe()
    {
        (Color sky, Color equator, Color ground) = Colors();
        var probe = default(SphericalHarmonicsL2);
        for (int c = 0; c < 3; c++)
        {
            float curve = ((sky[c] + ground[c]) * 0.5f) - equator[c];
            probe[c, 0] = equator[c] + (curve / 3f);
            probe[c, 1] = (sky[c] - ground[c]) * 0.5f;
            probe[c, 6] = -curve / 6f;
            probe[c, 8] = -curve * 0.5f;
        }

        return probe;
    }
}
