using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Which lights are drawn: the sun and four point lights. What else a scene has is named once a light.</summary>
/// <remarks>Unity draws each further light in a ForwardAdd pass of its own; those passes are not drawn here.</remarks>
internal static class LightLimits
{
    public const int MaxPoints = 4;

    private static readonly HashSet<(int, string)> Reported = [];

    /// <summary>Point lights that are drawn if there are no more than <see cref="MaxPoints"/>, brightest first.</summary>
    public static IEnumerable<Light> Points => LightList.All
        .Where(l => l.type == LightType.Point && l.lightmapBakeType != LightmapBakeType.Baked)
        .OrderByDescending(l => l.intensity * l.range);

    /// <summary>Warns of every light that is not drawn, or not as Unity draws it.</summary>
    public static void Report()
    {
        Light? sun = LightList.Main;
        HashSet<Light> points = [.. Points.Take(MaxPoints)];
        foreach (Light light in LightList.All)
        {
            if (Reason(light, sun, points) is { } reason && Reported.Add((light.GetInstanceID(), reason)))
            {
                Debug.LogWarning($"Light '{light.name}' {reason}", light);
            }
        }
    }

    public static void Reset() => Reported.Clear();

    private static string? Reason(Light light, Light? sun, HashSet<Light> points)
    {
        if (light.intensity <= 0f || light.color.maxColorComponent <= 0f)
        {
            return null;
        }

        return light.type switch
        {
            _ when light.lightmapBakeType == LightmapBakeType.Baked => "is baked: lightmaps are not drawn here. Make it Realtime or Mixed.",
            LightType.Directional when light != sun => $"is not drawn: only one directional light is, '{sun?.name}'.",
            LightType.Spot => "is not drawn: spot lights are not supported here. Use a point light.",
            LightType.Point when !points.Contains(light) => $"is not drawn: only the {MaxPoints} brightest point lights are.",
            LightType.Point when light.shadows != LightShadows.None => "casts no shadow here: only the sun does.",
            LightType.Point or LightType.Directional => light.cookie != null ? "is drawn without its cookie." : null,
            _ => $"is not drawn: {light.type} lights are not supported here.",
        };
    }
}
