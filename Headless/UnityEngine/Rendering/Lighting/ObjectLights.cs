using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The lights of one object, as Unity's Built-in forward rendering chooses them.</summary>
/// <remarks>
/// The base pass has the brightest directional light. Each further light has a ForwardAdd pass: all Important ones, and the
/// brightest others while there are no more than QualitySettings.pixelLightCount, the base pass's light included. Of the rest
/// the four brightest point lights are vertex lights of the base pass. A shader without a ForwardAdd pass has only those.
/// </remarks>
internal sealed class ObjectLights
{
    public const int MaxVertex = 4;

    public Light? Main { get; private init; }
    public IReadOnlyList<Light> Pixel { get; private init; } = [];
    public IReadOnlyList<Light> Vertex { get; private init; } = [];

    /// <summary>What Unity adds to the object's ambient light, as spherical harmonics; that is not done here.</summary>
    public IReadOnlyList<Light> Rest { get; private init; } = [];

    /// <summary>What the variables say outside an object's lit passes.</summary>
    public static ObjectLights OfScene => new() { Main = LightList.Main };

    /// <param name="hasAdditivePass">Whether the shader draws further lights.</param>
    public static ObjectLights Of(DrawRequest draw, bool hasAdditivePass)
    {
        List<Light> lit = [.. LightList.All.Where(l => LightList.IsDrawn(l) && Reaches(l, draw))];
        Light? main = LightList.Main is { } sun && lit.Contains(sun)
            ? sun
            : lit.Where(LightList.CanBeMain).MaxBy(l => Brightness(l, draw.Bounds));
        List<Light> others = [.. lit.Where(l => l != main).OrderByDescending(l => Brightness(l, draw.Bounds))];
        int free = QualitySettings.pixelLightCount - (main != null ? 1 : 0) - others.Count(l => l.renderMode == LightRenderMode.ForcePixel);
        HashSet<Light> pixel = hasAdditivePass
            ?
            [
                .. others.Where(l => l.renderMode == LightRenderMode.ForcePixel),
                .. others.Where(l => l.renderMode == LightRenderMode.Auto).Take(Mathf.Max(0, free)),
            ]
            : [];
        List<Light> vertex = [.. others.Where(l => !pixel.Contains(l) && l.type == LightType.Point).Take(MaxVertex)];
        return new ObjectLights
        {
            Main = main,
            Pixel = [.. others.Where(pixel.Contains)],
            Vertex = vertex,
            Rest = [.. others.Where(l => !pixel.Contains(l) && !vertex.Contains(l))],
        };
    }

    /// <summary>By its range, its cone and its culling mask.</summary>
    public static bool Reaches(Light light, DrawRequest draw) => (light.cullingMask & (1 << draw.Layer)) != 0 && Reaches(light, draw.Bounds);

    public static float Brightness(Light light, in Bounds bounds)
    {
        float color = light.intensity * light.color.maxColorComponent;
        return light.type == LightType.Directional
            ? color
            : color * LightTextures.At(Mathf.Sqrt(bounds.SqrDistance(light.transform.position)) / Mathf.Max(1e-4f, light.range));
    }

    private static bool Reaches(Light light, in Bounds bounds)
    {
        if (light.type == LightType.Directional)
        {
            return true;
        }

        Vector3 from = light.transform.position;
        return bounds.SqrDistance(from) <= light.range * light.range && (light.type == LightType.Point || ConeTouches(light, from, bounds));
    }

    /// <summary>Against the sphere round the box.</summary>
    private static bool ConeTouches(Light light, Vector3 from, in Bounds bounds)
    {
        Vector3 to = bounds.center - from;
        float radius = bounds.extents.magnitude;
        float along = Vector3.Dot(to, light.transform.forward);
        float across = Mathf.Sqrt(Mathf.Max(0f, to.sqrMagnitude - (along * along)));
        float half = light.spotAngle * 0.5f * Mathf.Deg2Rad;
        return along > -radius && (across * Mathf.Cos(half)) - (along * Mathf.Sin(half)) <= radius;
    }
}
