using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Counts the neighbours within the support radius on the CPU: mean and maximum over the particles.</summary>
    public readonly struct NeighbourCount
    {
        private NeighbourCount(double mean, int maximum)
        {
            Mean = mean;
            Maximum = maximum;
        }

        /// <summary>Mean number of other particles within R.</summary>
        public double Mean { get; }

        /// <summary>Largest number of other particles within R.</summary>
        public int Maximum { get; }

        /// <summary>Counts by a grid of cells of edge R; particles that are not finite count as having none.</summary>
        public static NeighbourCount Of(Vector3[] positions, float supportRadius)
        {
            if (positions.Length == 0) return new NeighbourCount(0, 0);
            var cells = new CellLists(positions, supportRadius);
            long sum = 0;
            int maximum = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                int count = cells.CountWithin(positions, i, supportRadius);
                sum += count;
                maximum = Math.Max(maximum, count);
            }
            return new NeighbourCount((double)sum / positions.Length, maximum);
        }
    }
}
