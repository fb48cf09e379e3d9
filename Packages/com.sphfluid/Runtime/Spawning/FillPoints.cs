using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where a liquid's particles are at the start: all of them, or as many as may be shown, evenly among them.</summary>
    internal sealed class FillPoints
    {
        /// <summary>Most points that are shown.</summary>
        public const int Most = 10000;

        // Its share of a number is as far from any fraction as can be, so that the points lie in no rows.
        private const double GoldenShare = 0.6180339887498949;

        /// <summary>Of all particles.</summary>
        /// <param name="particles">The particles.</param>
        /// <param name="most">Most points.</param>
        public FillPoints(IReadOnlyList<FluidParticle> particles, int most = Most)
        {
            Total = particles.Count;
            var shown = new Vector3[Math.Min(Total, most)];
            long stride = shown.Length == Total ? 1 : Stride(Total);
            for (int i = 0; i < shown.Length; i++) shown[i] = particles[(int)(i * stride % Total)].Position;
            Shown = shown;
        }

        /// <summary>Number of particles.</summary>
        public int Total { get; }

        /// <summary>Positions in simulation space [m], each of another particle.</summary>
        public IReadOnlyList<Vector3> Shown { get; }

        // Without a common divisor, so that no particle comes twice.
        private static long Stride(long total)
        {
            long stride = Math.Max(1L, (long)(GoldenShare * total));
            while (Divisor(stride, total) > 1) stride++;
            return stride;
        }

        private static long Divisor(long a, long b)
        {
            while (b != 0) (a, b) = (b, a % b);
            return a;
        }
    }
}
