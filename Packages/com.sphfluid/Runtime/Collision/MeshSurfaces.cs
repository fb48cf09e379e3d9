using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Which triangles of a mesh make up one surface: those that share an edge which no third one has. Their corners may run either way; of
    /// which triangles they run the other way than of the first is told. Corners within a millionth of the mesh's size are one.
    /// </summary>
    internal sealed class MeshSurfaces
    {
        /// <summary>Bits of <see cref="Edges"/> for the edges ab, bc and ca: the triangle beyond lies in the same plane.</summary>
        public const uint InPlane = 7u;

        /// <summary>Bit of <see cref="Edges"/>: the corners run the other way than those of the surface's first triangle.</summary>
        public const uint Turned = 8u;

        /// <summary>
        /// Bits beside those of <see cref="Edges"/>: the solid is deep on the side from which the normal looks, and on that to which it
        /// looks.
        /// </summary>
        public const uint DeepBehind = 16u, DeepAhead = 32u, Deep = DeepBehind | DeepAhead;

        /// <summary>Bits of <see cref="Edges"/> below the number of the surface.</summary>
        public const int NumberShift = 8;

        // Of the angle between two planes that are one.
        private const double Coplanar = 1e-4;

        private readonly int[] parent;
        private readonly bool[] turned; // against the parent
        private MeshSurfaces deforming;

        /// <summary>The surfaces of a mesh.</summary>
        public MeshSurfaces(TriangleMesh mesh)
        {
            int count = mesh.TriangleCount;
            Edges = new uint[count];
            Order = new int[count];
            parent = new int[count];
            turned = new bool[count];
            for (int t = 0; t < count; t++) parent[t] = t;
            Join(mesh, mesh.Welded);
            Number();
        }

        private MeshSurfaces(MeshSurfaces other)
        {
            Order = other.Order;
            Count = other.Count;
            Edges = Array.ConvertAll(other.Edges, e => e & ~InPlane);
            deforming = this; // a mesh that deforms in each frame is made from the one of the frame before
        }

        /// <summary>Of each triangle: bits for its edges, whether it is turned, and the number of its surface.</summary>
        public uint[] Edges { get; }

        /// <summary>The triangles, surface by surface.</summary>
        public int[] Order { get; }

        /// <summary>Number of surfaces.</summary>
        public int Count { get; private set; }

        /// <summary>The same surfaces where corners move: no two triangles stay in one plane.</summary>
        public MeshSurfaces Deforming => deforming ??= new MeshSurfaces(this);

        private void Join(TriangleMesh mesh, int[] welded)
        {
            var seen = new Dictionary<(int, int), Edge>(Edges.Length * 3 / 2);
            for (int t = 0; t < Edges.Length; t++)
                for (int k = 0; k < 3; k++)
                {
                    int from = welded[mesh.Indices[3 * t + k]], to = welded[mesh.Indices[3 * t + (k + 1) % 3]];
                    if (from == to) continue;
                    (int, int) key = from < to ? (from, to) : (to, from);
                    seen.TryGetValue(key, out Edge edge);
                    if (edge.Uses == 0) (edge.First, edge.FirstForward) = (3 * t + k, from < to);
                    else if (edge.Uses == 1) (edge.Second, edge.SecondForward) = (3 * t + k, from < to);
                    edge.Uses++;
                    seen[key] = edge;
                }
            foreach (Edge edge in seen.Values)
            {
                if (edge.Uses != 2 || edge.First / 3 == edge.Second / 3) continue;
                bool against = edge.FirstForward == edge.SecondForward;
                Unite(edge.First / 3, edge.Second / 3, against);
                if (!IsOnePlane(mesh, edge.First / 3, edge.Second / 3, against)) continue;
                Edges[edge.First / 3] |= 1u << edge.First % 3;
                Edges[edge.Second / 3] |= 1u << edge.Second % 3;
            }
        }

        private static bool IsOnePlane(TriangleMesh mesh, int first, int second, bool against)
        {
            BodyTriangle a = Triangle(mesh, first), b = Triangle(mesh, second);
            var n = new Vector3(a.NormalX, a.NormalY, a.NormalZ);
            var m = new Vector3(b.NormalX, b.NormalY, b.NormalZ);
            return n != Vector3.zero && m != Vector3.zero && (n - (against ? -m : m)).magnitude < Coplanar;
        }

        private static BodyTriangle Triangle(TriangleMesh mesh, int index)
        {
            mesh.GetTriangle(index, out Vector3 a, out Vector3 b, out Vector3 c);
            return BodyTriangle.Create(a, b, c);
        }

        private (int root, bool turned) Find(int t)
        {
            bool against = false;
            int root = t;
            for (; parent[root] != root; root = parent[root]) against ^= turned[root];
            bool left = against;
            while (parent[t] != root && t != root)
            {
                int next = parent[t];
                bool own = turned[t];
                (parent[t], turned[t]) = (root, left);
                left ^= own;
                t = next;
            }
            return (root, against);
        }

        private void Unite(int a, int b, bool against)
        {
            (int rootA, bool turnedA) = Find(a);
            (int rootB, bool turnedB) = Find(b);
            if (rootA == rootB) return; // a surface with one side only has no other way to be told
            (int low, int high) = rootA < rootB ? (rootA, rootB) : (rootB, rootA);
            parent[high] = low;
            turned[high] = turnedA ^ turnedB ^ against;
        }

        private void Number()
        {
            var numbers = new int[Edges.Length];
            var roots = new Dictionary<int, int>();
            for (int t = 0; t < Edges.Length; t++)
            {
                (int root, bool isTurned) = Find(t);
                if (!roots.TryGetValue(root, out numbers[t])) roots.Add(root, numbers[t] = Count++);
                Edges[t] |= (isTurned ? Turned : 0u) | (uint)numbers[t] << NumberShift;
                Order[t] = t;
            }
            Array.Sort(numbers, Order); // unstable within a surface, whose order is of no account
        }

        private struct Edge
        {
            public int Uses, First, Second; // three times the triangle, plus the edge
            public bool FirstForward, SecondForward;
        }
    }
}
