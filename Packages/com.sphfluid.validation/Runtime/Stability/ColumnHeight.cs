using System;

namespace SphFluid.Validation
{
    /// <summary>Height of a column on the domain's lower face.</summary>
    static class ColumnHeight
    {
        /// <summary>Half a spacing above the median of its highest layer's worth of particles [m]: a few that fly do not count.</summary>
        /// <param name="state">The particles.</param>
        /// <param name="settings">Domain and spacing.</param>
        /// <param name="depth">Height at rest density [m], which tells how many layers there are.</param>
        public static double Of(FluidSnapshot state, in FluidSolverSettings settings, double depth)
        {
            var heights = new double[state.Count];
            for (int i = 0; i < heights.Length; i++)
                heights[i] = state.LocalPositions[i].y + 0.5 * settings.DomainSize.y;
            Array.Sort(heights);
            int layers = Math.Max(1, (int)Math.Round(depth / settings.Spacing));
            int layer = Math.Max(1, state.Count / layers);
            return heights[heights.Length - 1 - layer / 2] + 0.5 * settings.Spacing;
        }
    }
}
