using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The reflection probes of what a camera sees.</summary>
internal sealed class CulledProbes
{
    private readonly ReflectionProbe[] probes;

    /// <summary>Realtime probes that are due are drawn.</summary>
    public CulledProbes(IEnumerable<ReflectionProbe> all, Frustum frustum, ReflectionProbeSortingCriteria order)
    {
        probes = [.. Sorted(all.Where(p => p.texture != null && frustum.Touches(p.bounds)), order)];
        Visible = NativeMemoryOwner.Array<VisibleReflectionProbe>(Array.ConvertAll(probes, p => new VisibleReflectionProbe(p)));
        IndexMap = [.. Enumerable.Range(0, probes.Length)];
    }

    public NativeArray<VisibleReflectionProbe> Visible { get; }
    public int[] IndexMap { get; private set; }

    public void SetIndexMap(NativeArray<int> indices) =>
        IndexMap = indices.IsCreated ? indices.ToArray() : [.. Enumerable.Range(0, probes.Length)];

    public int Count(DrawRequest draw) =>
        draw.Reflections == ReflectionProbeUsage.Off ? 0 : probes.Count(p => p.bounds.Intersects(draw.Bounds));

    private static IEnumerable<ReflectionProbe> Sorted(IEnumerable<ReflectionProbe> found, ReflectionProbeSortingCriteria order) => order switch
    {
        ReflectionProbeSortingCriteria.Importance => found.OrderByDescending(p => p.importance),
        ReflectionProbeSortingCriteria.Size => found.OrderBy(p => p.size.sqrMagnitude),
        ReflectionProbeSortingCriteria.ImportanceThenSize => found.OrderByDescending(p => p.importance).ThenBy(p => p.size.sqrMagnitude),
        _ => found,
    };
}
