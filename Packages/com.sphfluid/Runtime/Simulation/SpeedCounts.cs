using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Particles of a liquid counted by the squares of what moves them, in bins (Shaders/Simulation/MeasureSpeeds.compute).
    /// </summary>
    internal static class SpeedCounts
    {
        /// <summary>Bins of each kind: eight an octave of the square from 2^−40 on, the last one without an end.</summary>
        public const int Bins = 512;

        /// <summary>Where the kinds begin: v², v² + 2 (Φ − lowest Φ), the square of the distance from kept places.</summary>
        public const int Speeds = 0, Heads = Bins, Distances = 2 * Bins;

        /// <summary>The bits of the fastest speed of the steps [m/s].</summary>
        public const int Fastest = 3 * Bins;

        /// <summary>The sum of the particles' compressions, in 64ths.</summary>
        public const int Compression = Fastest + 1;

        /// <summary>Numbers in all.</summary>
        public const int Size = Compression + 1;

        private const int FirstBin = 696, Shift = 20;

        /// <summary>The bin of a square.</summary>
        public static int BinOf(float square)
        {
            int bin = (BitConverter.SingleToInt32Bits(square) & 0x7fffffff) >> Shift;
            return Math.Min(Math.Max(bin, FirstBin) - FirstBin, Bins - 1);
        }

        /// <summary>Root of a bin's upper edge; infinite for the last.</summary>
        public static float UpperEdge(int bin) =>
            bin >= Bins - 1 ? float.PositiveInfinity : (float)Math.Sqrt(BitConverter.Int32BitsToSingle((FirstBin + bin + 1) << Shift));

        /// <summary>Mean of max(ρ/ρ0 − 1, 0); 0 where nothing was counted.</summary>
        /// <param name="counts">The numbers.</param>
        public static float MeanCompression(IReadOnlyList<uint> counts) => counts[Compression] / 64f / Math.Max(1L, Count(counts, Speeds));

        /// <summary>What a share of the particles does not exceed, by up to 6 % too much; 0 where nothing was counted.</summary>
        /// <param name="counts">The numbers.</param>
        /// <param name="kind">Where the kind begins.</param>
        /// <param name="share">0 to 1; 1 is the largest.</param>
        public static float Quantile(IReadOnlyList<uint> counts, int kind, double share)
        {
            long all = Count(counts, kind);
            if (all == 0) return 0f;
            long least = Math.Max(1L, (long)Math.Ceiling(share * all)), below = 0;
            for (int bin = 0; bin < Bins; bin++)
            {
                below += counts[kind + bin];
                if (below >= least) return UpperEdge(bin);
            }
            return float.PositiveInfinity;
        }

        /// <summary>Part of the particles that do not move, 0 to 1: the first bin's, below 10⁻⁶ m/s.</summary>
        public static float StillShare(IReadOnlyList<uint> counts) => counts[Speeds] / (float)Math.Max(1L, Count(counts, Speeds));

        /// <summary>How many particles a kind has.</summary>
        public static long Count(IReadOnlyList<uint> counts, int kind)
        {
            long all = 0;
            for (int bin = 0; bin < Bins; bin++) all += counts[kind + bin];
            return all;
        }
    }

    /// <summary>How fast a liquid was at the end of a frame.</summary>
    internal struct SpeedSample
    {
        // One drop in a hundred particles does not hold the rest.
        private const double BulkShare = 0.99;

        /// <summary>Fastest particle of the frame's steps [m/s].</summary>
        public float Fastest;

        /// <summary>Speed that all but a hundredth do not exceed at the end of the frame [m/s].</summary>
        public float Bulk;

        /// <summary>
        /// Speed that all but a hundredth do not exceed now, nor would at the domain's lowest place, √(v² + 2 g h), less what liquid at
        /// rest has of that without falling [m/s].
        /// </summary>
        public float Head;

        /// <summary>Fastest particle at the end of the frame, up to 6 % too much [m/s].</summary>
        public float Present;

        /// <summary>
        /// Distance from where they were when their places were kept that half of the particles do not exceed, up to 6 % too much [m].
        /// </summary>
        public float HalfDistance;

        /// <summary>The distance that all but a hundredth do not exceed, up to 6 % too much [m].</summary>
        public float Distance;

        /// <summary>The farthest of these distances, up to 6 % too much [m].</summary>
        public float Farthest;

        /// <summary>Mean compression of the particles, max(ρ/ρ0 − 1, 0).</summary>
        public float Compression;

        /// <summary>Number of the keeping of places that the distances are from; 0: none.</summary>
        public int Kept;

        /// <summary>From the numbers of a measurement.</summary>
        /// <param name="counts">The numbers.</param>
        /// <param name="kept">Number of the keeping of places that the distances are from; 0: none.</param>
        /// <param name="rest">What each particle that is counted takes off the squares of heads, for what cannot fall [m²/s²].</param>
        public static SpeedSample Evaluate(IReadOnlyList<uint> counts, int kept, double rest) => new SpeedSample
        {
            Fastest = Finite(BitConverter.Int32BitsToSingle(unchecked((int)counts[SpeedCounts.Fastest]))),
            Bulk = SpeedCounts.Quantile(counts, SpeedCounts.Speeds, BulkShare),
            Head = HeadOf(counts, rest),
            Present = SpeedCounts.Quantile(counts, SpeedCounts.Speeds, 1.0),
            HalfDistance = SpeedCounts.Quantile(counts, SpeedCounts.Distances, 0.5),
            Distance = SpeedCounts.Quantile(counts, SpeedCounts.Distances, BulkShare),
            Farthest = SpeedCounts.Quantile(counts, SpeedCounts.Distances, 1.0),
            Compression = SpeedCounts.MeanCompression(counts),
            Kept = kept,
        };

        private static float HeadOf(IReadOnlyList<uint> counts, double rest)
        {
            double head = SpeedCounts.Quantile(counts, SpeedCounts.Heads, BulkShare);
            double above = head * head - rest * SpeedCounts.Count(counts, SpeedCounts.Heads);
            return Math.Max(SpeedCounts.Quantile(counts, SpeedCounts.Speeds, BulkShare), (float)Math.Sqrt(Math.Max(0.0, above)));
        }

        /// <summary>A liquid at a speed without a number has flown apart; the guards report it.</summary>
        public static float Finite(float speed) => speed >= 0f && speed < float.PositiveInfinity ? speed : float.MaxValue;
    }
}
