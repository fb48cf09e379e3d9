using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// How the triangles of a mesh hang together by its indices. A closed surface has each edge in two triangles that run along it in
    /// opposite directions.
    /// </summary>
    public readonly struct MeshEdges
    {
        private MeshEdges(int vertices, int edges, int triangles, int open, int nonManifold, int flipped)
        {
            Vertices = vertices;
            Count = edges;
            Triangles = triangles;
            OpenEdges = open;
            NonManifoldEdges = nonManifold;
            FlippedEdges = flipped;
        }

        /// <summary>Vertices that triangles use.</summary>
        public int Vertices { get; }

        /// <summary>Number of edges.</summary>
        public int Count { get; }

        /// <summary>Number of triangles.</summary>
        public int Triangles { get; }

        /// <summary>Edges of one triangle only: the rim of a hole.</summary>
        public int OpenEdges { get; }

        /// <summary>Edges of three triangles or more.</summary>
        public int NonManifoldEdges { get; }

        /// <summary>Edges of two triangles that run along it in the same direction: one of them is turned over.</summary>
        public int FlippedEdges { get; }

        /// <summary>Euler characteristic V − E + T: 2 for each closed body without a handle, 0 for a torus.</summary>
        public int Euler => Vertices - Count + Triangles;

        /// <summary>Whether no edge is open, non-manifold or flipped.</summary>
        public bool IsClosed => OpenEdges == 0 && NonManifoldEdges == 0 && FlippedEdges == 0;

        /// <summary>Counts.</summary>
        /// <param name="mesh">Any mesh; the empty one is closed.</param>
        public static MeshEdges Of(SurfaceMesh mesh)
        {
            ulong[] sides = SortedSides(mesh.Indices);
            int edges = 0, open = 0, nonManifold = 0, flipped = 0;
            for (int first = 0, end; first < sides.Length; first = end)
            {
                int upwards = 0;
                for (end = first; end < sides.Length && sides[end] >> 1 == sides[first] >> 1; end++) upwards += (int)(sides[end] & 1);
                int users = end - first;
                edges++;
                open += users == 1 ? 1 : 0;
                nonManifold += users > 2 ? 1 : 0;
                flipped += users == 2 && upwards != 1 ? 1 : 0;
            }
            return new MeshEdges(CountUsed(mesh), edges, mesh.TriangleCount, open, nonManifold, flipped);
        }

        // Lower vertex, higher vertex (31 bits) and whether the side runs from the lower to the higher one; sides of an edge stand
        // together.
        private static ulong[] SortedSides(int[] indices)
        {
            var sides = new ulong[indices.Length];
            for (int i = 0; i < indices.Length; i++)
            {
                int from = indices[i], to = indices[i % 3 == 2 ? i - 2 : i + 1];
                sides[i] = (ulong)Math.Min(from, to) << 32 | (ulong)Math.Max(from, to) << 1 | (from < to ? 1UL : 0UL);
            }
            Array.Sort(sides);
            return sides;
        }

        private static int CountUsed(SurfaceMesh mesh)
        {
            var used = new bool[mesh.VertexCount];
            int count = 0;
            foreach (int index in mesh.Indices)
            {
                count += used[index] ? 0 : 1;
                used[index] = true;
            }
            return count;
        }
    }
}
