using System;

namespace SphFluid.Validation
{
    /// <summary>Where a liquid that lies on a floor ends.</summary>
    internal static class LiquidSurface
    {
        /// <summary>
        /// Height at which the liquid, each particle spread over two spacings up and down, falls to half of the rest density: half a
        /// spacing above the last layer of a lattice, and the same where the particles at the surface lie in another order. A few that fly
        /// do not count.
        /// </summary>
        /// <param name="heights">Particles' heights above the floor [m]; sorted by this.</param>
        /// <param name="layer">Particles in a layer of a spacing at rest density.</param>
        /// <param name="spacing">dx [m].</param>
        /// <returns>The height [m]; zero where there is less than a layer.</returns>
        public static double Height(double[] heights, int layer, double spacing)
        {
            Array.Sort(heights);
            double high = heights.Length > 0 ? heights[heights.Length - 1] + 2.0 * spacing : 0.0, low = high;
            while (low > 0.0 && Filling(heights, layer, spacing, low) < 0.5)
            {
                high = low;
                low -= 0.25 * spacing;
            }
            if (low <= 0.0) return 0.0;
            for (int i = 0; i < 40; i++)
            {
                double middle = 0.5 * (low + high);
                if (Filling(heights, layer, spacing, middle) < 0.5)
                    high = middle;
                else
                    low = middle;
            }
            return low;
        }

        // Over the rest density.
        private static double Filling(double[] sorted, int layer, double spacing, double height)
        {
            double sum = 0.0;
            for (int i = sorted.Length - 1; i >= 0 && sorted[i] > height - 2.0 * spacing; i--)
            {
                sum += Math.Max(0.0, 1.0 - Math.Abs(sorted[i] - height) / (2.0 * spacing));
            }
            return 0.5 * sum / layer;
        }
    }
}
