using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>How many particles a search by cells looks at for one particle: all of the cells that it visits, itself included.</summary>
    public static class CandidateCount
    {
        /// <summary>
        /// Mean over the particles. A full lattice of spacing dx has 27 κ³ in 27 cells of R = κ dx, 64 κ³ in 8 cells of 2R.
        /// </summary>
        /// <param name="positions">Positions [m], in the grid's domain.</param>
        /// <param name="grid">The search's cells, none of them periodic.</param>
        /// <param name="octant">True: the 8 cells about the particle's octant. False: the 27 about its cell.</param>
        public static double Mean(Vector3[] positions, in FluidGrid grid, bool octant)
        {
            if (positions.Length == 0) return 0.0;
            var particles = new int[grid.CellCount];
            foreach (Vector3 position in positions)
            {
                Vector3Int cell = Vector3Int.FloorToInt(Place(grid, position));
                cell.Clamp(Vector3Int.zero, grid.Counts - Vector3Int.one);
                particles[Index(grid, cell)]++;
            }
            long sum = 0;
            foreach (Vector3 position in positions)
            {
                Vector3 place = Place(grid, position);
                Vector3Int first = octant ? Vector3Int.FloorToInt(place - 0.5f * Vector3.one)
                    : Vector3Int.FloorToInt(place) - Vector3Int.one;
                Vector3Int last = first + (octant ? 1 : 2) * Vector3Int.one;
                first = Vector3Int.Max(first, Vector3Int.zero);
                last = Vector3Int.Min(last, grid.Counts - Vector3Int.one);
                for (int z = first.z; z <= last.z; z++)
                    for (int y = first.y; y <= last.y; y++)
                        for (int x = first.x; x <= last.x; x++) sum += particles[Index(grid, new Vector3Int(x, y, z))];
            }
            return (double)sum / positions.Length;
        }

        private static Vector3 Place(in FluidGrid grid, Vector3 position)
        {
            Vector3 p = position - grid.Origin;
            return new Vector3(p.x / grid.CellSize.x, p.y / grid.CellSize.y, p.z / grid.CellSize.z);
        }

        private static int Index(in FluidGrid grid, Vector3Int cell) => cell.x + grid.Counts.x * (cell.y + grid.Counts.y * cell.z);
    }
}
