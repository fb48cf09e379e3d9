using System;
using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>
    /// When particles leave again. A layer of an emitter has ids that follow each other, so a range of ids and a time stand for all of it,
    /// whatever other emitters give meanwhile; a particle itself carries no time.
    /// </summary>
    internal sealed class ParticleLifetimes
    {
        /// <summary>Most ranges that one sort takes; others wait for the next.</summary>
        public const int MostDue = 64;

        private readonly IdRange[] due = new IdRange[1 + MostDue];
        private IdRange[] ranges = new IdRange[64];
        private double[] ends = new double[64];
        private double earliest = double.PositiveInfinity;

        /// <summary>Ranges that wait for their time.</summary>
        public int Waiting { get; private set; }

        /// <summary>What <see cref="RemoveDue"/> took last: their number as the first of element 0, and behind it the ranges.</summary>
        public IdRange[] Due => due;

        /// <summary>Adds a range.</summary>
        /// <param name="first">Its first id.</param>
        /// <param name="count">Number of ids, modulo 2^32.</param>
        /// <param name="end">Simulated time at which its particles leave [s].</param>
        public void Add(uint first, uint count, double end)
        {
            if (count == 0) return;
            if (Waiting == ranges.Length)
            {
                Array.Resize(ref ranges, Math.Max(64, 2 * Waiting));
                Array.Resize(ref ends, Math.Max(64, 2 * Waiting));
            }
            ranges[Waiting] = new IdRange { First = first, Count = count };
            ends[Waiting] = end;
            earliest = Math.Min(earliest, end);
            Waiting++;
        }

        /// <summary>Writes what waits.</summary>
        public void Save(SaveWriter writer)
        {
            writer.WriteItems(ranges, Waiting);
            writer.WriteItems(ends, Waiting);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            ranges = reader.ReadItems<IdRange>();
            ends = reader.ReadItems<double>();
            Waiting = ranges.Length;
            earliest = double.NegativeInfinity; // the next look finds it
        }

        /// <summary>Takes the ranges that leave in a step, the first that were added first.</summary>
        /// <param name="end">Simulated time at its end [s].</param>
        /// <param name="unborn">Id from which on nobody is born yet: a range of such ids waits.</param>
        /// <returns>Their number in <see cref="Due"/>.</returns>
        public int RemoveDue(double end, uint unborn)
        {
            due[0] = default;
            if (!(earliest <= end)) return 0;
            int kept = 0, taken = 0;
            earliest = double.PositiveInfinity;
            for (int i = 0; i < Waiting; i++)
            {
                IdRange range = ranges[i];
                bool isBorn = unchecked((int)(unborn - range.First - range.Count)) >= 0;
                if (ends[i] <= end && isBorn && taken < MostDue)
                {
                    due[++taken] = range;
                    continue;
                }
                ranges[kept] = range;
                ends[kept] = ends[i];
                earliest = Math.Min(earliest, ends[i]);
                kept++;
            }
            Waiting = kept;
            due[0].First = (uint)taken;
            return taken;
        }
    }

    /// <summary>Ids that follow each other, as the GPU reads them: 8 bytes, uint2.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct IdRange
    {
        public const int Stride = 8;

        public uint First, Count;
    }
}
