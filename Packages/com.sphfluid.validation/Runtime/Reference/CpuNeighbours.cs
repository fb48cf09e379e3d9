using Unity.Collections;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>
    /// The grid and its cell lists: Shaders/Solver/FluidGrid.hlsl and GridNeighbours.hlsl in double precision.
    /// A cell's particles are [First[cell], First[cell + 1]) of the sorted particles.
    /// </summary>
    internal struct CpuNeighbours
    {
        public double3 Origin;
        public double3 CellSize;
        public int3 Counts;
        public bool Octant;
        public CpuPeriod Period;

        [ReadOnly] public NativeArray<int> First;

        public CpuNeighbours(in FluidGrid grid, in FluidSolverSettings settings, NativeArray<int> first)
        {
            Origin = CpuFluidParticle.Double(grid.Origin);
            CellSize = CpuFluidParticle.Double(grid.CellSize);
            Counts = new int3(grid.Counts.x, grid.Counts.y, grid.Counts.z);
            Octant = settings.OctantSearch;
            Period = CpuPeriod.Of(settings);
            First = first;
        }

        /// <summary>
        /// Runs of particles to look through: 8 cells of 2h at the octant, or 9 rows of 3 cells of h; each in two runs where x is periodic.
        /// </summary>
        public int RangeCount => Octant ? 8 : Period.X ? 18 : 9;

        /// <summary>Cell of a position; a particle on the upper face belongs to the last cell.</summary>
        public int Cell(double3 position)
        {
            return Index(math.clamp(Floor((position - Origin) / CellSize), new int3(0, 0, 0), Counts - new int3(1, 1, 1)));
        }

        /// <summary>From the second position to the first, from the nearest image along periodic axes.</summary>
        public double3 Separation(double3 position, double3 from) => Period.Separation(position, from);

        /// <summary>The k-th run of sorted particles near a position; cells outside the grid hold none.</summary>
        public void Range(double3 position, int k, out int first, out int end)
        {
            first = 0;
            end = 0;
            double3 place = (position - Origin) / CellSize;
            if (Octant)
            {
                int3 cell = Wrap(Floor(place - new double3(0.5, 0.5, 0.5)) + new int3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
                if (Holds(cell))
                {
                    first = First[Index(cell)];
                    end = First[Index(cell) + 1];
                }
            }
            else
            {
                int3 cell = Floor(place);
                int x = cell.x;
                cell = Wrap(cell + new int3(0, k % 3 - 1, k / 3 % 3 - 1));
                int low = k < 9 ? math.max(x - 1, 0) : x < 1 ? Counts.x + x - 1 : 0;
                int high = k < 9 ? math.min(x + 1, Counts.x - 1) : x < 1 ? Counts.x - 1 : x + 1 - Counts.x;
                if (low <= high && Holds(new int3(low, cell.y, cell.z)))
                {
                    first = First[Index(new int3(low, cell.y, cell.z))];
                    end = First[Index(new int3(high, cell.y, cell.z)) + 1];
                }
            }
        }

        private static int3 Floor(double3 v) => new int3((int)math.floor(v.x), (int)math.floor(v.y), (int)math.floor(v.z));

        private int3 Wrap(int3 c) => new int3(Wrap(c.x, Counts.x, Period.X), Wrap(c.y, Counts.y, Period.Y), Wrap(c.z, Counts.z, Period.Z));

        private static int Wrap(int cell, int count, bool periodic) => !periodic ? cell : cell < 0 ? cell + count : cell < count ? cell
            : cell - count;

        private int Index(int3 cell) => cell.x + Counts.x * (cell.y + Counts.y * cell.z);

        private bool Holds(int3 c) => c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < Counts.x && c.y < Counts.y && c.z < Counts.z;
    }
}
