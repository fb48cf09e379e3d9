using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The thesis's grid (6.2) over the domain box, cells of side 2R for 8 of them or R for 27, numbered x first, then y, then z.</summary>
    public readonly struct FluidGrid
    {
        /// <summary>Grid over a domain box that is centred on the origin of simulation space.</summary>
        /// <param name="domainSize">Size of the box [m].</param>
        /// <param name="cellSize">Side of a cell [m]: 2R for the octant search to be complete, R for the search of 27 cells.</param>
        /// <exception cref="ArgumentException">A size is not positive, or the grid has more cells than an index can name.</exception>
        public FluidGrid(Vector3 domainSize, float cellSize)
        {
            if (!(domainSize.x > 0f && domainSize.y > 0f && domainSize.z > 0f && cellSize > 0f))
            {
                throw new ArgumentException(
                    $"The domain size {domainSize} m and the cell size {cellSize} m must be positive along every axis.");
            }

            double x = Math.Ceiling(domainSize.x / (double)cellSize);
            double y = Math.Ceiling(domainSize.y / (double)cellSize);
            double z = Math.Ceiling(domainSize.z / (double)cellSize);
            if (x * y * z > int.MaxValue)
            {
                throw new ArgumentException(
                    $"A domain of {domainSize} m has {x * y * z:E1} cells of {cellSize} m, more than {int.MaxValue}. " +
                    "Use a smaller domain or a larger particle spacing.");
            }

            Origin = -0.5f * domainSize;
            CellSize = cellSize;
            Counts = new Vector3Int((int)x, (int)y, (int)z);
        }

        /// <summary>Lower corner of the box in simulation space [m].</summary>
        public Vector3 Origin { get; }

        /// <summary>Side of a cell [m].</summary>
        public float CellSize { get; }

        /// <summary>Cells along each axis.</summary>
        public Vector3Int Counts { get; }

        /// <summary>Number of cells.</summary>
        public int CellCount => Counts.x * Counts.y * Counts.z;
    }
}
