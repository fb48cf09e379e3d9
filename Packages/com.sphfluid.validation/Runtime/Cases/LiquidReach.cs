using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// How far liquid reaches from a wall along one direction, spray left out. The liquid ends where fewer particles than a row
    /// lie within two spacings: one that flies ahead alone, or a few of them, are beyond the end.
    /// </summary>
    internal readonly struct LiquidReach
    {
        /// <summary>Largest stretch with less than a row, over dx: beyond it the particles do not touch at κ = 2.</summary>
        public const double Gap = 2.0;

        private LiquidReach(int count, double edge)
        {
            Count = count;
            Edge = edge;
        }

        /// <summary>Particles from the wall to the end of the liquid.</summary>
        public int Count { get; }

        /// <summary>Half a spacing beyond the mean of the last row [m]; zero without liquid at the wall.</summary>
        public double Edge { get; }

        /// <summary>The reach of particles.</summary>
        /// <param name="distances">Their distances from the wall [m]; they are sorted.</param>
        /// <param name="row">Number of particles in a row of the liquid across the direction.</param>
        /// <param name="spacing">dx [m].</param>
        public static LiquidReach Of(List<double> distances, int row, double spacing)
        {
            distances.Sort();
            double gap = Gap * spacing;
            int count = 0;
            while (count < distances.Count && distances[count] - (count < row ? 0.0 : distances[count - row]) <= gap) count++;
            double sum = 0.0;
            int last = Math.Min(row, count);
            for (int i = count - last; i < count; i++) sum += distances[i];
            return new LiquidReach(count, count == 0 ? 0.0 : sum / last + 0.5 * spacing);
        }
    }
}
