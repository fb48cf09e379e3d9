using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Lights that are enabled in the running scenes.</summary>
internal static class LightList
{
    private static readonly List<Light> Lights = [];

    public static IReadOnlyList<Light> All
    {
        get
        {
            Lights.RemoveAll(l => l == null);
            return SceneTable.Previews.Count == 0 ? Lights : Lights.FindAll(SceneTable.IsInWorld);
        }
    }

    /// <summary>RenderSettings.sun, or else the brightest directional light.</summary>
    public static Light? Main
    {
        get
        {
            Light? sun = RenderSettings.sun;
            return sun != null && sun.isActiveAndEnabled && CanBeMain(sun)
                ? sun
                : All.Where(CanBeMain).MaxBy(l => l.intensity * l.color.maxColorComponent);
        }
    }

    /// <summary>Lightmaps are not drawn here, and area lights have light in lightmaps only.</summary>
    public static bool IsDrawn(Light light) =>
        light.intensity > 0f && light.color.maxColorComponent > 0f && light.lightmapBakeType != LightmapBakeType.Baked
        && light.type is LightType.Directional or LightType.Point or LightType.Spot;

    /// <summary>A light whose Render Mode is Not Important is never drawn per pixel.</summary>
    public static bool CanBeMain(Light light) =>
        IsDrawn(light) && light.type == LightType.Directional && light.renderMode != LightRenderMode.ForceVertex;

    public static void Add(Light light) => Lights.Add(light);

    public static void Remove(Light light) => Lights.RemoveAll(l => ReferenceEquals(l, light));
}
