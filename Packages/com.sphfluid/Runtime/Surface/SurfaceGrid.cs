using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The marching-cubes grid: a box in simulation space cut into cells. Its vertices, one more than cells along each
    /// axis, are numbered x first, then y, then z; the outermost ones lie on the walls of the domain.
    /// </summary>
    public readonly struct SurfaceGrid : IEquatable<SurfaceGrid>
    {
        /// <summary>Most cells a side of a grid with as many along each axis.</summary>
        public const int MaximumCells = 1024;

        // A table of the sparse surface has a number of four bytes for each block of 8³ cubes: 2 GiB.
        private const double MostBlocks = 1 << 29, CubesPerSide = 8.0;

        /// <summary>A grid over a box, with the same number of cells along each axis.</summary>
        /// <param name="minimum">Lowest corner of the box [m], simulation space.</param>
        /// <param name="size">Edges of the box [m], each greater than zero.</param>
        /// <param name="cells">Cells a side, 1 to <see cref="MaximumCells"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">An edge is not a positive number, or the number of cells is
        /// out of range.</exception>
        public SurfaceGrid(Vector3 minimum, Vector3 size, int cells)
            : this(minimum, size, Vector3Int.one * cells)
        {
            if (cells > MaximumCells)
            {
                throw new ArgumentOutOfRangeException(nameof(cells),
                    $"A surface grid has 1 to {MaximumCells} cells a side, not {cells}.");
            }
        }

        /// <summary>A grid over a box.</summary>
        /// <param name="minimum">Lowest corner of the box [m], simulation space.</param>
        /// <param name="size">Edges of the box [m], each greater than zero.</param>
        /// <param name="cells">Cells along each axis, one or more; of blocks of 8³ cubes there are 2²⁹ at most.</param>
        /// <exception cref="ArgumentOutOfRangeException">An edge is not a positive number, or a number of cells is out
        /// of range.</exception>
        public SurfaceGrid(Vector3 minimum, Vector3 size, Vector3Int cells)
        {
            if (!IsBox(size) || !IsFinite(minimum))
            {
                throw new ArgumentOutOfRangeException(nameof(size),
                    $"A surface grid needs a box with edges greater than zero; this one is {size} m at {minimum}.");
            }
            if (cells.x < 1 || cells.y < 1 || cells.z < 1)
            {
                throw new ArgumentOutOfRangeException(nameof(cells),
                    $"A surface grid has one cell or more along each axis, not {cells}.");
            }
            if (!Fits(cells)) throw TooMany(nameof(cells), cells);
            Minimum = minimum;
            Size = size;
            Cells = cells;
        }

        /// <summary>Lowest corner [m], simulation space.</summary>
        public Vector3 Minimum { get; }

        /// <summary>Edges of the box [m].</summary>
        public Vector3 Size { get; }

        /// <summary>Cells along each axis; zero in a grid made without a size.</summary>
        public Vector3Int Cells { get; }

        /// <summary>Vertices along each axis: one more than cells.</summary>
        public Vector3Int Vertices => Cells + Vector3Int.one;

        /// <summary>Edges of a cell [m].</summary>
        public Vector3 CellSize => new Vector3(Size.x / Cells.x, Size.y / Cells.y, Size.z / Cells.z);

        /// <summary>Number of grid vertices.</summary>
        /// <exception cref="OverflowException">There are more than an index can name, as a sparse surface may have.</exception>
        public int VertexCount => Product(Vertices);

        /// <summary>
        /// Cubes of marching cubes along each axis: the cells, and a thin ring around them that closes the mesh at the
        /// walls.
        /// </summary>
        public Vector3Int Cubes => Cells + 2 * Vector3Int.one;

        /// <summary>Number of cubes of marching cubes.</summary>
        /// <exception cref="OverflowException">There are more than an index can name, as a sparse surface may have.</exception>
        public int CubeCount => Product(Cubes);

        /// <summary>The grid over the domain of a simulation, in cells that are nearly cubes.</summary>
        /// <param name="domainSize">Edges of the domain [m].</param>
        /// <param name="cellEdge">Longest edge of a cell [m]; 0.3 cuts an edge of 1 m into 4 cells of 0.25 m.</param>
        /// <returns>A grid whose outermost vertices lie on the domain's walls.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The edge is not a positive number, or so short that the cells
        /// are too many.</exception>
        public static SurfaceGrid OverDomain(Vector3 domainSize, float cellEdge)
        {
            if (!(cellEdge > 0f) || float.IsInfinity(cellEdge))
            {
                throw new ArgumentOutOfRangeException(nameof(cellEdge),
                    $"The cells of a surface grid need an edge greater than zero, not {cellEdge} m.");
            }
            Vector3 cells = Domain(domainSize) / cellEdge;
            cells = new Vector3(Mathf.Ceil(cells.x), Mathf.Ceil(cells.y), Mathf.Ceil(cells.z));
            if (!Fits(cells)) throw TooMany(nameof(cellEdge), cells);
            return new SurfaceGrid(domainSize * -0.5f, domainSize, Vector3Int.RoundToInt(cells));
        }

        /// <summary>Position of a grid vertex.</summary>
        /// <param name="x">Number along x, 0 to the number of cells.</param>
        /// <param name="y">Number along y.</param>
        /// <param name="z">Number along z.</param>
        /// <returns>Position [m], simulation space.</returns>
        public Vector3 Position(int x, int y, int z) => Minimum + Vector3.Scale(CellSize, new Vector3(x, y, z));

        /// <summary>Number of a grid vertex in the field.</summary>
        /// <param name="x">Number along x, 0 to the number of cells.</param>
        /// <param name="y">Number along y.</param>
        /// <param name="z">Number along z.</param>
        /// <returns>Index, x fastest.</returns>
        public int Index(int x, int y, int z) => (z * Vertices.y + y) * Vertices.x + x;

        /// <inheritdoc/>
        public bool Equals(SurfaceGrid other) => Minimum == other.Minimum && Size == other.Size && Cells == other.Cells;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is SurfaceGrid other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Minimum, Size, Cells);

        /// <summary>Where a corner of a cube lies, after Bourke's numbering; e.g. corner 2 at (1, 1, 0).</summary>
        internal static Vector3Int CornerOffset(int corner) =>
            new Vector3Int((corner + 1) >> 1 & 1, corner >> 1 & 1, corner >> 2);

        /// <summary>The edges of a domain, checked.</summary>
        internal static Vector3 Domain(Vector3 domainSize) => IsBox(domainSize) ? domainSize
            : throw new ArgumentOutOfRangeException(nameof(domainSize),
                $"A surface grid needs a domain with edges greater than zero, not {domainSize} m.");

        private static int Product(Vector3Int counts) => checked(counts.x * counts.y * counts.z);

        private static bool Fits(Vector3 cells) => Blocks(cells.x) * Blocks(cells.y) * Blocks(cells.z) <= MostBlocks;

        // With the ring: 64 cells have 66 cubes, 9 blocks.
        private static double Blocks(double cells) => Math.Ceiling((cells + 2.0) / CubesPerSide);

        private static ArgumentOutOfRangeException TooMany(string parameter, Vector3 cells) =>
            new ArgumentOutOfRangeException(parameter,
            $"A surface grid of {cells.x:F0} x {cells.y:F0} x {cells.z:F0} cells is too fine for its table, which has a number for " +
            "each 8 x 8 x 8 of them. Choose larger cells or a smaller domain.");

        private static bool IsBox(Vector3 size) => size.x > 0f && size.y > 0f && size.z > 0f && IsFinite(size);

        private static bool IsFinite(Vector3 v) => !float.IsNaN(v.sqrMagnitude) && !float.IsInfinity(v.sqrMagnitude);
    }
}
