using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Names every light that is not drawn, or not as Unity draws it, once.</summary>
internal static class LightReport
{
    private static readonly HashSet<(int, string)> Reported = [];

    /// <summary>What follows from the light alone.</summary>
    public static void OfScene()
    {
        foreach (Light light in LightList.All)
        {
            if (light.intensity > 0f && light.color.maxColorComponent > 0f && Reason(light) is { } reason)
            {
                Name(light, reason, reason);
            }
        }
    }

    /// <summary>Lights that Unity would add to the object's ambient light.</summary>
    public static void OfObject(DrawRequest draw, ObjectLights lights, bool hasAdditivePass)
    {
        foreach (Light light in lights.Rest)
        {
            string why = light.renderMode == LightRenderMode.ForceVertex ? "its Render Mode is Not Important"
                : !hasAdditivePass ? $"the shader '{draw.Material.shader.name}' has no ForwardAdd pass"
                : $"QualitySettings.pixelLightCount is {QualitySettings.pixelLightCount}, and others are brighter";
            Name(
                light, why,
                $"is not drawn on material '{draw.Material.name}': {why}. Unity would add it to the ambient light, which is not done here.");
        }
    }

    public static void Reset() => Reported.Clear();

    private static void Name(Light light, string kind, string text)
    {
        if (Reported.Add((light.GetInstanceID(), kind)))
        {
            Debug.LogWarning($"Light '{light.name}' {text}", light);
        }
    }

    private static string? Reason(Light light) => light switch
    {
        { lightmapBakeType: LightmapBakeType.Baked } => "is baked: lightmaps are not drawn here. Make it Realtime or Mixed.",
        { type: not (LightType.Directional or LightType.Point or LightType.Spot) } => $"is not drawn: {light.type} lights are not supported here.",
        { type: LightType.Directional or LightType.Point, cookie: not null } => "is drawn without its cookie.",
        _ when light.shadows != LightShadows.None && light != LightList.Main => "casts no shadow here: only the sun does.",
        _ => null,
    };
}
