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
            return sun != null && sun.isActiveAndEnabled && sun.type == LightType.Directional
                ? sun
                : All.Where(l => l.type == LightType.Directional).MaxBy(l => l.intensity * l.color.maxColorComponent);
        }
    }

    public static void Add(Light light) => Lights.Add(light);

    public static void Remove(Light light) => Lights.RemoveAll(l => ReferenceEquals(l, light));
}
