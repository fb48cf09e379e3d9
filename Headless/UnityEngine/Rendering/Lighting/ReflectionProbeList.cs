using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Reflection probes that are enabled in the running scenes.</summary>
internal static class ReflectionProbeList
{
    private static readonly List<ReflectionProbe> Probes = [];

    public static IEnumerable<ReflectionProbe> All
    {
        get
        {
            Probes.RemoveAll(p => p == null);
            return Probes.Where(SceneTable.IsInWorld);
        }
    }

    public static void Add(ReflectionProbe probe) => Probes.Add(probe);

    public static void Remove(ReflectionProbe probe) => Probes.RemoveAll(p => ReferenceEquals(p, probe));

    /// <summary>The probe for an object: the most important one that touches its box, and of equals the one that shares most of it.</summary>
    public static ReflectionProbe? For(in Bounds bounds)
    {
        ReflectionProbe? best = null;
        float bestShare = 0f;
        foreach (ReflectionProbe probe in All)
        {
            if (probe.texture is not { } texture || texture == null || texture.dimension != TextureDimension.Cube || !probe.bounds.Intersects(bounds))
            {
                continue;
            }

            float share = SharedVolume(probe.bounds, bounds);
            if (best is null || probe.importance > best.importance || (probe.importance == best.importance && share > bestShare))
            {
                (best, bestShare) = (probe, share);
            }
        }

        return best;
    }

    private static float SharedVolume(in Bounds a, in Bounds b)
    {
        Vector3 sides = Vector3.Min(a.max, b.max) - Vector3.Max(a.min, b.min);
        return Mathf.Max(0f, sides.x) * Mathf.Max(0f, sides.y) * Mathf.Max(0f, sides.z);
    }
}
