using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The marching-cubes grid: a box in simulation space cut into the same number of cells along each axis. Its (cells + 1)^3 vertices are
    /// numbered x first, then y, then z; the outermost ones lie on the walls of the domain.
    /// </summary>
    public readonly struct SurfaceGrid : IEquatable<SurfaceGrid>
    {
        /// <summary>Most cells a side: the names of the grid edges, 3 x 1027^3 of them, still fit into 32 bits.</summary>
        public const int MaximumCells = 1024;

        /// <summary>A grid over a box.</summary>
        /// <param name="minimum">Lowest corner of the box [m], simulation space.</param>
        /// <param name="size">Edges of the box [m], each greater than zero.</param>
        /// <param name="cells">Cells a side, 1 to <see cref="MaximumCells"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">An edge is not a positive number, or the number of cells is out of range.</exception>
        public SurfaceGrid(Vector3 minimum, Vector3 size, int cells)
        {
            if (!(size.x > 0f && size.y > 0f && size.z > 0f) || !IsFinite(size) || !IsFinite(minimum))
                throw new ArgumentOutOfRangeException(nameof(size), $"A surface grid needs a box with edges greater than zero; this one is {size} m at {minimum}.");
            if (cells < 1 || cells > MaximumCells)
                throw new ArgumentOutOfRangeException(nameof(cells), $"A surface grid has 1 to {MaximumCells} cells a side, not {cells}.");
            Minimum = minimum;
            Size = size;
            Cells = cells;
        }

        /// <summary>Lowest corner [m], simulation space.</summary>
        public Vector3 Minimum { get; }

        /// <summary>Edges of the box [m].</summary>
        public Vector3 Size { get; }

        /// <summary>Cells a side.</summary>
        public int Cells { get; }

        /// <summary>Vertices a side: one more than cells.</summary>
        public int VerticesPerSide => Cells + 1;

        /// <summary>Edges of a cell [m]; a cell is a cube only if the box is one.</summary>
        public Vector3 CellSize => Size / Cells;

        /// <summary>Number of grid vertices.</summary>
        public int VertexCount => VerticesPerSide * VerticesPerSide * VerticesPerSide;

        /// <summary>Cubes of marching cubes a side: the cells, and a thin ring around them that closes the mesh at the walls.</summary>
        public int CubesPerSide => Cells + 2;

        /// <summary>Number of cubes of marching cubes.</summary>
        public int CubeCount => CubesPerSide * CubesPerSide * CubesPerSide;

        /// <summary>The grid over the domain of a simulation, which is centred on the origin of simulation space.</summary>
        /// <param name="domainSize">Edges of the domain [m].</param>
        /// <param name="size">Cells a side.</param>
        /// <returns>A grid whose outermost vertices lie on the domain's walls.</returns>
        public static SurfaceGrid OverDomain(Vector3 domainSize, SurfaceGridSize size) => new SurfaceGrid(domainSize * -0.5f, domainSize, size.Cells());

        /// <summary>Position of a grid vertex.</summary>
        /// <param name="x">Number along x, 0 to <see cref="Cells"/>.</param>
        /// <param name="y">Number along y.</param>
        /// <param name="z">Number along z.</param>
        /// <returns>Position [m], simulation space.</returns>
        public Vector3 Position(int x, int y, int z) => Minimum + Vector3.Scale(CellSize, new Vector3(x, y, z));

        /// <summary>Number of a grid vertex in the field.</summary>
        /// <param name="x">Number along x, 0 to <see cref="Cells"/>.</param>
        /// <param name="y">Number along y.</param>
        /// <param name="z">Number along z.</param>
        /// <returns>Index, x fastest.</returns>
        public int Index(int x, int y, int z) => (z * VerticesPerSide + y) * VerticesPerSide + x;

        /// <inheritdoc/>
        public bool Equals(SurfaceGrid other) => Minimum == other.Minimum && Size == other.Size && Cells == other.Cells;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is SurfaceGrid other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Minimum, Size, Cells);

        /// <summary>Where a corner of a cube lies, after Bourke's numbering; e.g. corner 2 at (1, 1, 0).</summary>
        internal static Vector3Int CornerOffset(int corner) => new Vector3Int((corner + 1) >> 1 & 1, corner >> 1 & 1, corner >> 2);

        // The two vectors of Shaders/Surface/MarchingCubes.hlsl.
        internal Vector4 MinimumAndCells => new Vector4(Minimum.x, Minimum.y, Minimum.z, Cells);

        internal Vector4 CellSizeAndIso(float isoValue)
        {
            Vector3 cell = CellSize;
            return new Vector4(cell.x, cell.y, cell.z, isoValue);
        }

        static bool IsFinite(Vector3 v) => !float.IsNaN(v.sqrMagnitude) && !float.IsInfinity(v.sqrMagnitude);
    }
}
