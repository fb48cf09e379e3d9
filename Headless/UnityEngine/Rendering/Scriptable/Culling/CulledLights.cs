using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The lights of what a camera sees, most important first, and the numbers that shaders know them by.</summary>
internal sealed class CulledLights
{
    private readonly Light[] lights;
    private int[] map;

    /// <param name="maximum">Negative for no limit.</param>
    public CulledLights(IEnumerable<Light> all, Frustum frustum, CameraView view, int maximum)
    {
        Light? main = LightList.Main;
        IEnumerable<Light> inView = all.Where(l => l.type == LightType.Directional || frustum.Touches(Sphere(l).Center, Sphere(l).Radius))
            .OrderBy(l => l.type == LightType.Directional ? ReferenceEquals(l, main) ? 0 : 1 : 2)
            .ThenByDescending(l => Importance(l, view.Position));
        lights = [.. maximum < 0 ? inView : inView.Take(maximum)];
        Visible = NativeMemoryOwner.Array<VisibleLight>(Array.ConvertAll(lights, l => LightOnScreen.Of(l, view)));
        map = [.. Enumerable.Range(0, lights.Length)];
    }

    public NativeArray<VisibleLight> Visible { get; }
    public int[] IndexMap => map;

    public Light this[int index] => (uint)index < (uint)lights.Length
        ? lights[index]
        : throw new ArgumentOutOfRangeException(nameof(index), $"There are {lights.Length} visible lights; there is none with index {index}.");

    public void SetIndexMap(NativeArray<int> indices)
    {
        if (indices.IsCreated && indices.Length != lights.Length)
        {
            throw new ArgumentException($"A light index map has a number for each of the {lights.Length} visible lights, not {indices.Length}.");
        }

        map = indices.IsCreated ? indices.ToArray() : [.. Enumerable.Range(0, lights.Length)];
    }

    public bool Reaches(int index, DrawRequest draw) => (uint)index < (uint)lights.Length && ObjectLights.Reaches(lights[index], draw);

    /// <summary>The numbers of an object's lights, brightest first.</summary>
    public List<int> Of(DrawRequest draw)
    {
        var found = new List<(int Number, float Brightness)>();
        for (int i = 0; i < lights.Length; i++)
        {
            if (map[i] >= 0 && ObjectLights.Reaches(lights[i], draw))
            {
                found.Add((map[i], ObjectLights.Brightness(lights[i], draw.Bounds)));
            }
        }

        return [.. found.OrderByDescending(l => l.Brightness).Select(l => l.Number)];
    }

    /// <summary>Around all that the light reaches.</summary>
    public static (Vector3 Center, float Radius) Sphere(Light light)
    {
        float half = light.spotAngle * 0.5f * Mathf.Deg2Rad;
        if (light.type != LightType.Spot || half > Mathf.PI / 4f)
        {
            return (light.transform.position, light.range);
        }

        // Through the tip and the rim of the cone.
        float radius = light.range / (2f * Mathf.Cos(half));
        return (light.transform.position + (light.transform.forward * radius), radius);
    }

    private static float Importance(Light light, Vector3 viewer)
    {
        float color = light.intensity * light.color.maxColorComponent;
        return light.type == LightType.Directional ? color : color / Mathf.Max(1f, (light.transform.position - viewer).sqrMagnitude);
    }
}
