using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Objects in the order of SortingSettings; equal ones as they were found.</summary>
internal static class SortedDraws
{
    public static IEnumerable<DrawRequest> Of(IEnumerable<DrawRequest> draws, SortingSettings settings)
    {
        SortingCriteria by = settings.criteria;
        IOrderedEnumerable<DrawRequest> sorted = draws.OrderBy(d => 0);
        if ((by & SortingCriteria.SortingLayer) != 0)
        {
            sorted = sorted.ThenBy(d => d.SortingLayer).ThenBy(d => d.SortingOrder);
        }

        if ((by & SortingCriteria.RenderQueue) != 0)
        {
            sorted = sorted.ThenBy(d => d.Material.renderQueue);
        }

        if ((by & SortingCriteria.RendererPriority) != 0)
        {
            sorted = sorted.ThenBy(d => d.Priority);
        }

        if ((by & SortingCriteria.BackToFront) != 0)
        {
            sorted = sorted.ThenByDescending(d => settings.Distance(d.Bounds.center));
        }
        else if ((by & SortingCriteria.QuantizedFrontToBack) != 0)
        {
            sorted = sorted.ThenBy(d => settings.Distance(d.Bounds.center));
        }

        return sorted;
    }
}
