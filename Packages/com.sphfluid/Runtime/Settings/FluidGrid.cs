using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The thesis's grid (6.2) over the domain box, cells of side 2R for 8 of them or R for 27, numbered x first, then y, then z.
    /// Along periodic axes the cells divide the box evenly, so they are somewhat longer.
    /// </summary>
    public readonly struct FluidGrid
    {
        // Two cells of 2R, the octant's, or three of R: with fewer the loop would visit one of them twice.
        private const int OctantCells = 2;
        private const int RowCells = 3;

        // What a product of a number of cells and their size may miss by rounding to float.
        private const double Rounding = 1e-6;

        /// <summary>Grid over a domain box that is centred on the origin of simulation space, walls all around.</summary>
        /// <param name="domainSize">Size of the box [m].</param>
        /// <param name="cellSize">Side of a cell [m]: 2R for the octant search to be complete, R for the search of 27 cells.</param>
        /// <exception cref="ArgumentException">A size is not positive, or the grid has more cells than an index can name.</exception>
        public FluidGrid(Vector3 domainSize, float cellSize)
            : this(domainSize, cellSize, FluidAxes.None, 1)
        {
        }

        private FluidGrid(Vector3 domainSize, float cellSize, FluidAxes periodic, int leastCells)
        {
            Require.Size(domainSize, nameof(domainSize));
            Require.Positive(cellSize, nameof(cellSize));

            double x = Cells(domainSize.x, cellSize, periodic, FluidAxes.X, leastCells);
            double y = Cells(domainSize.y, cellSize, periodic, FluidAxes.Y, leastCells);
            double z = Cells(domainSize.z, cellSize, periodic, FluidAxes.Z, leastCells);
            if (x * y * z > int.MaxValue)
            {
                throw new ArgumentException(
                    $"A domain of {domainSize} m has {x * y * z:E1} cells of {cellSize} m, more than {int.MaxValue}. " +
                    "Use a smaller domain or a larger particle spacing.");
            }

            Origin = -0.5f * domainSize;
            Counts = new Vector3Int((int)x, (int)y, (int)z);
            CellSize = new Vector3(
                (periodic & FluidAxes.X) != 0 ? (float)(domainSize.x / x) : cellSize,
                (periodic & FluidAxes.Y) != 0 ? (float)(domainSize.y / y) : cellSize,
                (periodic & FluidAxes.Z) != 0 ? (float)(domainSize.z / z) : cellSize);
        }

        /// <summary>Lower corner of the box in simulation space [m].</summary>
        public Vector3 Origin { get; }

        /// <summary>Sides of a cell [m].</summary>
        public Vector3 CellSize { get; }

        /// <summary>Cells along each axis.</summary>
        public Vector3Int Counts { get; }

        /// <summary>Number of cells.</summary>
        public int CellCount => Counts.x * Counts.y * Counts.z;

        /// <summary>The grid that a neighbour search needs.</summary>
        /// <param name="settings">Domain, support radius, search and periodic axes.</param>
        /// <returns>Cells of 2R or R, evenly along periodic axes.</returns>
        /// <exception cref="ArgumentException">A periodic axis is too short for the search, or there are too many cells.</exception>
        public static FluidGrid For(in FluidSolverSettings settings)
        {
            return new FluidGrid(settings.DomainSize, CellSizeOf(settings), settings.Boundaries.Periodic,
                settings.OctantSearch ? OctantCells : RowCells);
        }

        /// <summary>Checks that a running liquid can go on with other settings in its grid.</summary>
        /// <param name="settings">Its settings.</param>
        /// <param name="next">The others.</param>
        /// <exception cref="ArgumentException">They have another grid.</exception>
        internal static void CheckKept(in FluidSolverSettings settings, in FluidSolverSettings next)
        {
            if (next.DomainSize != settings.DomainSize || next.SupportRadius != settings.SupportRadius ||
                next.OctantSearch != settings.OctantSearch ||
                next.Boundaries.Periodic != settings.Boundaries.Periodic)
            {
                throw new ArgumentException(
                    "DomainSize, SupportRadius, OctantSearch and Boundaries.Periodic cannot change while the liquid runs: " +
                    "the grid depends on them. Start a new solver.");
            }
        }

        /// <summary>Number of cells that the grid of some settings has, however many, with a number more along each axis.</summary>
        internal static double CountFor(in FluidSolverSettings settings, int border)
        {
            float cell = CellSizeOf(settings);
            FluidAxes periodic = settings.Boundaries.Periodic;
            return (Cells(settings.DomainSize.x, cell, periodic, FluidAxes.X, 0) + border) *
                (Cells(settings.DomainSize.y, cell, periodic, FluidAxes.Y, 0) + border) *
                (Cells(settings.DomainSize.z, cell, periodic, FluidAxes.Z, 0) + border);
        }

        private static float CellSizeOf(in FluidSolverSettings settings) => settings.OctantSearch ? 2f * settings.SupportRadius
            : settings.SupportRadius;

        // 1 m in cells of 0.3 m: 4 between walls, the last reaching over; 3 of 0.333 m on a periodic axis.
        private static double Cells(float length, float cellSize, FluidAxes periodic, FluidAxes axis, int leastCells)
        {
            if ((periodic & axis) == 0) return Math.Ceiling(length / (double)cellSize);

            double count = Math.Floor(length / (double)cellSize * (1.0 + Rounding));
            if (count < leastCells)
            {
                double radius = leastCells == OctantCells ? 0.5 * cellSize : cellSize;
                throw new ArgumentException(
                    $"The domain is {length:G6} m along {axis}, which is periodic, but with a support radius R = {radius:G6} m it must " +
                    "be " +
                    $"{leastCells * cellSize:G6} m or more: {leastCells} cells of {cellSize:G6} m. Enlarge the domain along {axis}, use " +
                    "a smaller " +
                    (leastCells == OctantCells ? "spacing, or set OctantSearch off, for which 3 R are enough."
                        : "spacing, or give the axis walls."));
            }

            return count;
        }
    }
}
