using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Marching cubes on the CPU, cube by cube over the whole grid: what the kernels count and emit. Written from the
    /// definition of the grid; only the tables are the product's, which have tests of their own.
    /// </summary>
    internal sealed class MarchingCubesReference
    {
        private const float EdgeMargin = 0.01f;
        private const float RingThickness = 0.02f;

        private readonly SurfaceGrid grid;
        private readonly Func<Vector3Int, float> value;
        private readonly float iso;
        private readonly int ring;

        /// <summary>A surface.</summary>
        /// <param name="grid">The grid.</param>
        /// <param name="value">Field values at grid vertices.</param>
        /// <param name="iso">Value of the field on the surface.</param>
        /// <param name="walls">Closed: the cubes of the ring count too.</param>
        public MarchingCubesReference(SurfaceGrid grid, Func<Vector3Int, float> value, float iso,
            SurfaceWalls walls = SurfaceWalls.Closed)
        {
            this.grid = grid;
            this.value = value;
            this.iso = iso;
            ring = walls == SurfaceWalls.Closed ? 1 : 0;
        }

        /// <summary>Lowest cube along each axis.</summary>
        public Vector3Int FirstCube => -ring * Vector3Int.one;

        /// <summary>One above the highest cube along each axis.</summary>
        public Vector3Int EndCube => grid.Cells + ring * Vector3Int.one;

        /// <summary>Whether a sample, the ring's included, lies inside the liquid; the ring is empty.</summary>
        public bool IsInside(Vector3Int s) => Value(s) >= iso;

        /// <summary>Edges between neighbouring samples of a box, both ends included, that the surface cuts.</summary>
        public int CutEdges(Vector3Int first, Vector3Int last)
        {
            int cut = 0;
            foreach (Vector3Int s in Box(first, last + Vector3Int.one))
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    Vector3Int next = s;
                    next[axis]++;
                    cut += next[axis] <= last[axis] && IsInside(s) != IsInside(next) ? 1 : 0;
                }
            }
            return cut;
        }

        /// <summary>Corners of the triangles in a box of cubes, three a triangle.</summary>
        public int Corners(Vector3Int firstCube, Vector3Int endCube)
        {
            int corners = 0;
            foreach (Vector3Int cube in Box(firstCube, endCube)) corners += Row(cube).Count;
            return corners;
        }

        /// <summary>
        /// The whole mesh; its vertices are shared by the triangles around them. Normals are not computed.
        /// </summary>
        public SurfaceMesh Mesh()
        {
            var numbers = new Dictionary<(Vector3Int, Vector3Int), int>();
            var positions = new List<Vector3>();
            var indices = new List<int>();
            foreach (Vector3Int cube in Box(FirstCube, EndCube))
            {
                foreach (int edge in Row(cube))
                {
                    Vector3Int a = cube + Corner(edge, 0), b = cube + Corner(edge, 1);
                    if (!numbers.TryGetValue((a, b), out int number))
                    {
                        numbers.Add((a, b), number = positions.Count);
                        positions.Add(Crossing(a, b));
                    }
                    indices.Add(number);
                }
            }
            return new SurfaceMesh(positions.ToArray(), new Vector3[positions.Count], indices.ToArray());
        }

        /// <summary>Cubes, or samples, from first to before end, x fastest.</summary>
        public static IEnumerable<Vector3Int> Box(Vector3Int first, Vector3Int end)
        {
            for (int z = first.z; z < end.z; z++)
            {
                for (int y = first.y; y < end.y; y++)
                {
                    for (int x = first.x; x < end.x; x++) yield return new Vector3Int(x, y, z);
                }
            }
        }

        private float Value(Vector3Int s) =>
            s == Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(s, grid.Cells)) ? value(s) : 0f;

        // Edges of the cube's triangles, three a triangle: the row of its case.
        private List<int> Row(Vector3Int cube)
        {
            int outside = 0;
            for (int corner = 0; corner < 8; corner++) outside |= IsInside(cube + SurfaceGrid.CornerOffset(corner)) ? 0 : 1 << corner;
            var row = new List<int>();
            int first = outside * MarchingCubesTables.RowLength;
            int end = first + MarchingCubesTables.RowLength;
            for (int i = first; i < end && MarchingCubesTables.TriangleTable[i] >= 0; i++) row.Add(MarchingCubesTables.TriangleTable[i]);
            return row;
        }

        private static Vector3Int Corner(int edge, int end) =>
            SurfaceGrid.CornerOffset(MarchingCubesTables.EdgeCorners[2 * edge + end]);

        private Vector3 Crossing(Vector3Int a, Vector3Int b)
        {
            double t = (iso - (double)Value(a)) / ((double)Value(b) - Value(a));
            t = Math.Max(EdgeMargin, Math.Min(1.0 - EdgeMargin, t));
            Vector3 cell = grid.CellSize, p = default;
            for (int axis = 0; axis < 3; axis++)
            {
                double from = Squeezed(a[axis], grid.Cells[axis]), to = Squeezed(b[axis], grid.Cells[axis]);
                p[axis] = (float)(grid.Minimum[axis] + cell[axis] * (from + t * (to - from)));
            }
            return p;
        }

        // Of 8 cells with a ring: the samples -1, 0, 1 ... 7, 8, 9 lie at 0, 0.02, 1 ... 7, 7.98, 8.
        private double Squeezed(int s, int cells)
        {
            double thickness = ring * RingThickness;
            return s < 0 ? 0.0 : s > cells ? cells : Math.Max(thickness, Math.Min(cells - thickness, s));
        }
    }
}
