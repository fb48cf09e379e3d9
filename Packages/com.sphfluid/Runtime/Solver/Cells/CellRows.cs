using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Cells of side R with a border of one empty cell around the domain, numbered x first, then y, then z:
    /// Shaders/Solver/Cells/CellRows.hlsl. Three cells of a row follow each other, so 9 runs of particles serve for 27 cells.
    /// </summary>
    internal readonly struct CellRows
    {
        /// <summary>Cells that a group of the scan sums; SCAN_CELLS_PER_GROUP in CellSums.hlsl.</summary>
        internal const int CellsPerScanGroup = 2048;

        /// <summary>Parts in which the sum of a group's cells is counted; SCAN_SUM_PARTS in CellSums.hlsl.</summary>
        internal const int SumParts = 16;

        /// <summary>
        /// Most cells, border included, besides those that left the domain: their numbers are whole numbers of 32 bits with a sign. Above
        /// <see cref="SparseCells.MostDense"/> only those with particles are stored.
        /// </summary>
        public const int MaxCells = 2147483646;

        /// <summary>Cells of the border along an axis, both ends.</summary>
        internal const int Border = 2;

        /// <summary>The cells of a grid, and a border.</summary>
        /// <param name="grid">Cells of R over the domain.</param>
        /// <exception cref="ArgumentException">There are more cells than allowed; the message names the sizes and the cure.</exception>
        public CellRows(in FluidGrid grid)
        {
            Counts = grid.Counts + Border * Vector3Int.one;
            CellSize = grid.CellSize;
            Origin = grid.Origin - grid.CellSize;
            double total = (double)Counts.x * Counts.y * Counts.z;
            if (total > MaxCells)
            {
                throw new ArgumentException(
                    $"The domain has {Counts.x} x {Counts.y} x {Counts.z} cells of {CellSize.x} m, {total:E1} in all; " +
                    $"a sort by cells numbers {MaxCells:N0}. Use a smaller domain or a larger particle spacing.");
            }
        }

        /// <summary>Cells along each axis, the border included.</summary>
        public Vector3Int Counts { get; }

        /// <summary>Sides of a cell [m].</summary>
        public Vector3 CellSize { get; }

        /// <summary>Lower corner of the first border cell in simulation space [m].</summary>
        public Vector3 Origin { get; }

        /// <summary>Bytes of a cell in the table of the cells: its first particle, its count, and its part of the scan's sums.</summary>
        internal const double BytesPerCell = sizeof(uint) * (2.0 + (double)SumParts / CellsPerScanGroup);

        /// <summary>Groups of a scan over that many cells.</summary>
        internal static int ScanGroups(int cellCount) => (cellCount + CellsPerScanGroup - 1) / CellsPerScanGroup;

        /// <summary>Parts of sums of a scan over that many cells.</summary>
        internal static int ScanSums(int cellCount) => ScanGroups(cellCount) * SumParts;

        /// <summary>Number of cells, the border included.</summary>
        public int CellCount => Counts.x * Counts.y * Counts.z;
    }
}
