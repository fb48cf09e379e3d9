using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Solids that open meshes enclose together, as six faces of a crate do, or one whose seams gape: others run the opposite way along
    /// each of their open edges, nearer than liquid gets through. A place is in one where its triangles wind round it: their solid angles
    /// sum to 4π (A. Jacobson et al., "Robust Inside-Outside Segmentation using Generalized Winding Numbers", ACM Trans. Graph. 32(4),
    /// 2013).
    /// </summary>
    internal sealed class JoinedSolids
    {
        // Of the spacing: radius within which what runs along edges has to cancel. And how much may be left of an edge's own length.
        private const float Reach = 0.5f, Left = 0.25f;

        private const int MostSamples = 64;

        private readonly IReadOnlyList<FluidObstacle> solids;
        private readonly List<Edge> edges = new List<Edge>(); // by their lowest x
        private readonly List<Group> groups = new List<Group>();
        private readonly int[] parent; // of each mesh another of its group; −1 of one that has an inside of its own, or an opening
        private readonly float reach;
        private float longest;

        /// <param name="solids">The colliders, in simulation space.</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        public JoinedSolids(IReadOnlyList<FluidObstacle> solids, float spacing)
        {
            this.solids = solids;
            reach = Reach * spacing;
            parent = new int[solids.Count];
            for (int i = 0; i < parent.Length; i++) parent[i] = AddEdges(i) ? i : -1;
            edges.Sort((a, b) => a.Min.x.CompareTo(b.Min.x));
            while (DropOpen()) { }
            foreach (Edge edge in edges) ForEachNear(edge, other => parent[Root(other.Mesh)] = Root(edge.Mesh));
            Collect();
        }

        /// <summary>Number of the solid that a point is in, or −1.</summary>
        public int Find(Vector3 point) => groups.FindIndex(g => g.Bounds.Contains(point) && Winding(g, point) > 0.5);

        /// <summary>The colliders that enclose a solid.</summary>
        public IReadOnlyList<FluidObstacle> Members(int solid) => groups[solid].Members;

        // A ray counts the surfaces that wind round its start unless it passes an open edge. There cones over the edges close the meshes,
        // and what they add is taken off.
        private double Winding(Group group, Vector3 point)
        {
            double winding = 0.0;
            bool isNear = false;
            foreach (FluidObstacle member in group.Members) winding += member.Mesh.Crossings(point);
            foreach (Edge edge in group.Edges) isNear |= edge.IsNearRay(point, reach);
            if (!isNear) return winding;
            Vector3 apex = group.Bounds.center;
            foreach (Edge edge in group.Edges)
            {
                winding += edge.Times *
                    (TriangleMath.RayCrossing(point, apex, edge.To, edge.From) - TriangleMath.SolidAngle(point, apex, edge.To, edge.From));
            }
            return winding;
        }

        private bool AddEdges(int number)
        {
            TriangleMesh mesh = solids[number].Mesh;
            if (mesh.IsClosed) return false;
            foreach ((int from, int to, int times) in mesh.OpenEdges())
            {
                var edge = new Edge(number, mesh.Vertices[from], mesh.Vertices[to], times);
                if (!AffineMath.IsFinite(edge.From) || !AffineMath.IsFinite(edge.To)) return false;
                longest = Mathf.Max(longest, edge.Max.x - edge.Min.x);
                edges.Add(edge);
            }
            return true;
        }

        // One mesh that is open opens those beside it.
        private bool DropOpen()
        {
            int before = edges.Count;
            foreach (Edge edge in edges)
                if (parent[edge.Mesh] >= 0 && !IsClosedAlong(edge)) parent[edge.Mesh] = -1;
            edges.RemoveAll(e => parent[e.Mesh] < 0);
            return edges.Count < before;
        }

        private bool IsClosedAlong(in Edge edge)
        {
            Vector3 along = edge.To - edge.From;
            int samples = Mathf.Clamp(Mathf.CeilToInt(along.magnitude / (2f * reach)), 1, MostSamples);
            for (int s = 0; s < samples; s++)
            {
                Vector3 place = edge.From + (s + 0.5f) / samples * along, sum = Vector3.zero;
                for (int i = FirstNear(place.x); i < edges.Count && edges[i].Min.x <= place.x + reach; i++)
                    if (parent[edges[i].Mesh] >= 0) sum += edges[i].Within(place, reach);
                if (sum.magnitude > Left * edge.Within(place, reach).magnitude) return false;
            }
            return true;
        }

        private void ForEachNear(Edge edge, Action<Edge> visit)
        {
            for (int i = FirstNear(edge.Min.x); i < edges.Count && edges[i].Min.x <= edge.Max.x + reach; i++)
                if (edges[i].Mesh != edge.Mesh && edges[i].IsNear(edge, reach)) visit(edges[i]);
        }

        // The first edge that may reach as far as x.
        private int FirstNear(float x)
        {
            int low = 0, high = edges.Count;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (edges[middle].Min.x < x - reach - longest) low = middle + 1;
                else high = middle;
            }
            return low;
        }

        private int Root(int mesh)
        {
            while (parent[mesh] != mesh) mesh = parent[mesh];
            return mesh;
        }

        private void Collect()
        {
            var byRoot = new Dictionary<int, Group>();
            for (int i = 0; i < parent.Length; i++)
            {
                if (parent[i] < 0) continue;
                if (!byRoot.TryGetValue(Root(i), out Group group))
                {
                    byRoot.Add(Root(i), group = new Group { Bounds = solids[i].Mesh.Bounds });
                    groups.Add(group);
                }
                group.Members.Add(solids[i]);
                group.Bounds.Encapsulate(solids[i].Mesh.Bounds);
            }
            foreach (Edge edge in edges) byRoot[Root(edge.Mesh)].Edges.Add(edge);
        }

        private sealed class Group
        {
            public readonly List<FluidObstacle> Members = new List<FluidObstacle>();
            public readonly List<Edge> Edges = new List<Edge>();
            public Bounds Bounds;
        }

        private readonly struct Edge
        {
            public readonly int Mesh, Times;
            public readonly Vector3 From, To, Min, Max;

            public Edge(int mesh, Vector3 from, Vector3 to, int times)
            {
                (Mesh, From, To, Times) = (mesh, from, to, times);
                (Min, Max) = (Vector3.Min(from, to), Vector3.Max(from, to));
            }

            /// <summary>The part of the edge in a ball, as often as it is open.</summary>
            public Vector3 Within(Vector3 centre, float radius)
            {
                Vector3 along = To - From, away = From - centre;
                float square = along.sqrMagnitude, half = Vector3.Dot(along, away) / square;
                float root = half * half - (away.sqrMagnitude - radius * radius) / square;
                if (!(root > 0f)) return Vector3.zero;
                root = Mathf.Sqrt(root);
                return Times * Mathf.Max(Mathf.Min(root - half, 1f) - Mathf.Max(-root - half, 0f), 0f) * along;
            }

            public bool IsNearRay(Vector3 start, float reach) =>
                Max.x >= start.x - reach && Min.y <= start.y + reach && Max.y >= start.y - reach && Min.z <= start.z + reach &&
                    Max.z >= start.z - reach;

            public bool IsNear(in Edge other, float reach)
            {
                for (int axis = 0; axis < 3; axis++)
                    if (Min[axis] > other.Max[axis] + reach || Max[axis] < other.Min[axis] - reach) return false;
                return true;
            }
        }
    }
}
