using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The lookup tables of marching cubes in Bourke's form: which edges the surface cuts in each of the 256 cases, and
    /// the triangles between them. Corners and edges are numbered after P. Bourke, "Polygonising a scalar field"
    /// (1994); bit c of a case is set when corner c lies outside the liquid (value below the iso value).
    /// </summary>
    /// <remarks>
    /// The triangles are traced, not listed: on each face of the cube the surface joins cut edges, the joints form
    /// closed loops, the loops are cut into triangles. A face with two diagonal inside corners is ambiguous; its inside
    /// corners are always joined, as Bourke's table does. Both cubes at a face see the same four signs, so they agree
    /// and the mesh has no cracks (the complement rule of Lorensen and Cline's 15 cases cracks there).
    /// </remarks>
    internal static class MarchingCubesTables
    {
        /// <summary>Number of cases: one for each choice of outside corners.</summary>
        public const int CaseCount = 256;

        /// <summary>
        /// Length of a row of <see cref="TriangleTable"/>: at most 15 edges (5 triangles) and a closing -1.
        /// </summary>
        public const int RowLength = 16;

        private const int CornerCount = 8;
        private const int EdgeCount = 12;

        // The lower corner of an edge comes first, so that all cubes around an edge interpolate along it in the same
        // direction.
        private static readonly int[] Corners =
        {
            0, 1, 1, 2, 3, 2, 0, 3,
            4, 5, 5, 6, 7, 6, 4, 7,
            0, 4, 1, 5, 2, 6, 3, 7,
        };

        // Corners of the six faces, going round anticlockwise for a viewer outside who sees x to the right, y up and z
        // towards himself.
        private static readonly int[][] Faces =
        {
            new[] { 0, 3, 2, 1 }, new[] { 4, 5, 6, 7 },
            new[] { 0, 1, 5, 4 }, new[] { 3, 7, 6, 2 },
            new[] { 0, 4, 7, 3 }, new[] { 1, 2, 6, 5 },
        };

        private static readonly int[] Flags = new int[CaseCount];
        private static readonly int[] Rows = new int[CaseCount * RowLength];
        private static readonly int[] Lengths = new int[CaseCount];

        static MarchingCubesTables()
        {
            var polygon = new MarchingCubesPolygon(Corners);
            for (int index = 0; index < CaseCount; index++)
            {
                Flags[index] = CutEdges(index);
                WriteRow(index, Triangulate(index, polygon));
            }
        }

        /// <summary>256 sets of 12 bits: bit e is set when the surface cuts edge e.</summary>
        public static IReadOnlyList<int> EdgeTable => Flags;

        /// <summary>
        /// 256 rows of 16: the edges that hold the vertices of the case's triangles, three a triangle, then -1. Seen
        /// from outside the liquid the three run clockwise in Unity's left-handed space: cross(b - a, c - a) points out
        /// of the liquid.
        /// </summary>
        public static IReadOnlyList<int> TriangleTable => Rows;

        /// <summary>12 pairs: the two corners of each edge, the one nearer to the cube's origin first.</summary>
        public static IReadOnlyList<int> EdgeCorners => Corners;

        /// <summary>
        /// The three tables and the length of each row one behind the other, as
        /// Shaders/Surface/MarchingCubesTables.hlsl reads them.
        /// </summary>
        /// <returns>A new array of 256 + 4096 + 24 + 256 numbers.</returns>
        public static int[] Pack()
        {
            var packed = new List<int>(Flags);
            packed.AddRange(Rows);
            packed.AddRange(Corners);
            packed.AddRange(Lengths);
            return packed.ToArray();
        }

        /// <summary>The tables as kernels and shaders read them; the caller disposes the buffer.</summary>
        internal static FluidBuffer CreateBuffer()
        {
            int[] packed = Pack();
            var buffer = new FluidBuffer("MCTables", packed.Length, sizeof(int));
            buffer.SetData(packed);
            return buffer;
        }

        private static bool IsOutside(int index, int corner) => (index >> corner & 1) != 0;

        private static int CutEdges(int index)
        {
            int flags = 0;
            for (int edge = 0; edge < EdgeCount; edge++)
            {
                if (IsOutside(index, Corners[2 * edge]) != IsOutside(index, Corners[2 * edge + 1])) flags |= 1 << edge;
            }
            return flags;
        }

        private static List<int> Triangulate(int index, MarchingCubesPolygon polygon)
        {
            var triangles = new List<int>();
            foreach (List<int> loop in Loops(index)) triangles.AddRange(polygon.Triangulate(loop));
            return triangles;
        }

        /// <summary>
        /// The closed outlines that the surface draws on the faces of a cube: their cut edges in order.
        /// </summary>
        private static List<List<int>> Loops(int index)
        {
            var loops = new List<List<int>>();
            int[] next = JoinCutEdges(index);
            for (int start = 0; start < EdgeCount; start++)
            {
                var loop = new List<int>();
                for (int edge = start; next[edge] >= 0;)
                {
                    loop.Add(edge);
                    int following = next[edge];
                    next[edge] = -1;
                    edge = following;
                }
                if (loop.Count > 0) loops.Add(loop);
            }
            return loops;
        }

        // next[e] is the edge that the surface's outline runs to from edge e, or -1. Going round a face, an edge leaves
        // the liquid and the next cut edge enters it again: the outline cuts off the outside corners between them, and
        // runs from the entering to the leaving edge.
        private static int[] JoinCutEdges(int index)
        {
            var next = new int[EdgeCount];
            for (int edge = 0; edge < EdgeCount; edge++) next[edge] = -1;
            foreach (int[] face in Faces)
            {
                for (int i = 0; i < 4; i++)
                {
                    bool leaves = !IsOutside(index, face[i]) && IsOutside(index, face[(i + 1) % 4]);
                    if (!leaves) continue;
                    int j = (i + 1) % 4;
                    while (IsOutside(index, face[(j + 1) % 4])) j = (j + 1) % 4;
                    next[EdgeBetween(face[j], face[(j + 1) % 4])] = EdgeBetween(face[i], face[(i + 1) % 4]);
                }
            }
            return next;
        }

        private static int EdgeBetween(int a, int b)
        {
            for (int edge = 0; edge < EdgeCount; edge++)
            {
                int first = Corners[2 * edge];
                int second = Corners[2 * edge + 1];
                if (first == a && second == b || first == b && second == a) return edge;
            }
            throw new ArgumentException($"Corners {a} and {b} of a cube (0 to {CornerCount - 1}) are not joined by an edge.");
        }

        private static void WriteRow(int index, List<int> triangles)
        {
            Lengths[index] = triangles.Count;
            for (int slot = 0; slot < RowLength; slot++) Rows[index * RowLength + slot] = slot < triangles.Count ? triangles[slot] : -1;
        }
    }
}
