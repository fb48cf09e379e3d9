using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Memory that a step must move, by what its passes read and write once: neighbours that are read count as found in caches, and so do a
    /// mesh's triangles and the walls near particles.
    /// </summary>
    public static class StepBytes
    {
        // Of FluidParticle, 48 bytes: position and id, or those and one velocity.
        private const long Pair = 8, Particle = 48, Position = 16, PositionAndVelocity = 32;
        private const int ThesisPassesBesidesSort = 8;

        // The bitonic sort takes a power of two of pairs, and a block of them at least.
        private const long SortBlock = 1024;

        /// <summary>
        /// Bytes of a step of the Standard method. 16,384 particles and 12,167 cells, no list: 192 · 16,384 + 36 · 12,167 = 3.6 MB.
        /// </summary>
        /// <param name="particles">Number of particles.</param>
        /// <param name="cells">Number of cells.</param>
        /// <param name="stableOrder">Whether particles of a cell are ordered.</param>
        /// <param name="mesh">Whether there are triangles.</param>
        /// <param name="listed">Mean number of neighbours that are listed; null for none and no list.</param>
        public static long Standard(long particles, long cells, bool stableOrder, bool mesh, double? listed)
        {
            const long vector = 16, word = 4, density = 8;
            long scan = 3 * word * cells;
            long scatter = stableOrder
                ? particles * (vector + 2 * word + word + 4 * vector) + 2 * word * cells
                : particles * (word + 4 * vector) + word * cells;
            long densities = particles * (vector + density) + word * cells;
            long motion = particles * (2 * vector + density + 2 * vector + word) + 3 * word * cells;
            long walls = mesh ? particles * (vector + word + 2 * word + 2 * vector) : 0;
            long list = listed.HasValue ? (long)(particles * 2 * word * (1.0 + listed.Value)) : 0;
            return scan + scatter + densities + motion + walls + list;
        }

        /// <summary>Bytes of a step of the Robust method, the density for readers behind it included.</summary>
        /// <param name="particles">Number of particles.</param>
        /// <param name="cells">Number of cells.</param>
        /// <param name="iterations">Iterations of the step.</param>
        /// <param name="listed">Mean number of neighbours that are listed; null for none and no list.</param>
        public static long Robust(long particles, long cells, int iterations, double? listed)
        {
            const long vector = 16, word = 4;
            long list = listed.HasValue ? (long)(particles * word * (1.0 + listed.Value)) : 0;
            long sort = 3 * word * cells + particles * (vector + 2 * word + word + 6 * vector) + 2 * word * cells;
            long prediction = particles * (2 * vector + 3 * vector + word) + 3 * word * cells;
            long constraint = particles * 2 * vector + word * cells + list;
            long move = particles * (3 * vector + 3 * vector + vector) + list;
            long finish = particles * (4 * vector + 3 * vector + word) + 3 * word * cells + list;
            return prediction + 2 * sort + iterations * (constraint + move) + finish + constraint;
        }

        /// <summary>Bytes of a step of the thesis method.</summary>
        /// <param name="particles">Number of particles.</param>
        /// <param name="cells">Number of cells.</param>
        /// <param name="dispatches">Dispatches of the step, all but 8 of them of the sort.</param>
        public static long Thesis(long particles, long cells, long dispatches)
        {
            const long vector = 16, word = 4;
            long padded = Mathf.NextPowerOfTwo((int)Math.Max(particles, SortBlock));
            long keys = particles * Position + padded * Pair;
            long sort = (dispatches - ThesisPassesBesidesSort) * 2 * Pair * padded;
            long ranges = particles * Pair + 2 * Pair * cells;
            long reorder = particles * (Pair + 2 * Particle);
            long density = particles * (Position + 2 * word) + Pair * cells;
            long force = particles * (PositionAndVelocity + 2 * word + vector) + Pair * cells;
            long acceleration = particles * (PositionAndVelocity + word + 2 * vector);
            long motion = particles * (2 * Particle + vector);
            return keys + sort + ranges + reorder + density + force + acceleration + motion;
        }

        /// <summary>Bytes of a row's step.</summary>
        /// <param name="row">The row, measured once at least.</param>
        public static long Of(BenchRow row)
        {
            BenchSolver solver = row.Config.Solver;
            if (solver.Method == FluidMethodKind.Robust)
            {
                return Robust(row.Particles, row.Cells, 2, row.IsListed ? row.NeighboursMean : (double?)null);
            }
            return solver.Method == FluidMethodKind.Standard
                ? Standard(row.Particles, row.Cells, solver.StableOrder, solver.HasMesh, row.IsListed ? row.NeighboursMean : (double?)null)
                : Thesis(row.Particles, row.Cells, row.Dispatches);
        }
    }
}
