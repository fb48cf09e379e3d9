using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// How near particles are to each other, counted on the CPU: pairs nearer than half a spacing stand for a volume that the liquid
    /// then lacks elsewhere. <see cref="FluidStatistics.Clumped"/> is the same count on the GPU.
    /// </summary>
    public readonly struct ParticleGaps
    {
        private const float Close = 0.5f;

        private ParticleGaps(int closeCount, int count, double nearest)
        {
            CloseCount = closeCount;
            CloseShare = count > 0 ? (double)closeCount / count : 0.0;
            Nearest = nearest;
        }

        /// <summary>Particles whose nearest neighbour is within dx/2.</summary>
        public int CloseCount { get; }

        /// <summary>Their share of all.</summary>
        public double CloseShare { get; }

        /// <summary>Distance of the nearest pair over dx; 1 where no pair is nearer than that.</summary>
        public double Nearest { get; }

        /// <summary>Measures by a grid of cells of edge dx; particles that are not finite count as having no neighbours.</summary>
        /// <param name="positions">Places [m].</param>
        /// <param name="spacing">dx [m].</param>
        public static ParticleGaps Of(Vector3[] positions, float spacing)
        {
            var cells = new CellLists(positions, spacing);
            float close = Close * spacing * (Close * spacing), nearest = spacing * spacing;
            int count = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                float own = float.PositiveInfinity;
                foreach (int other in cells.Around(positions[i]))
                {
                    if (other != i) own = Math.Min(own, (positions[other] - positions[i]).sqrMagnitude);
                }

                count += own < close ? 1 : 0;
                nearest = Math.Min(nearest, own);
            }

            return new ParticleGaps(count, positions.Length, Math.Sqrt(nearest) / spacing);
        }
    }
}
