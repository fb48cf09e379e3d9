using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Cuts a closed loop of cut cube edges into triangles. No diagonal lies in a face of the cube, where the
    /// neighbouring cube could draw the same one: each edge of the mesh then belongs to exactly two triangles. Of the
    /// cuts that are left the one with the shortest diagonals is taken.
    /// </summary>
    internal sealed class MarchingCubesPolygon
    {
        // Twice the midpoints of the cube's edges: two edges lie in a common face when a coordinate is 0 in both or 2
        // in both.
        private readonly Vector3Int[] midpoints;
        private readonly List<int> best = new List<int>();
        private int bestCost;

        public MarchingCubesPolygon(int[] edgeCorners)
        {
            midpoints = new Vector3Int[edgeCorners.Length / 2];
            for (int edge = 0; edge < midpoints.Length; edge++)
            {
                midpoints[edge] =
                    SurfaceGrid.CornerOffset(edgeCorners[2 * edge]) + SurfaceGrid.CornerOffset(edgeCorners[2 * edge + 1]);
            }
        }

        /// <summary>Triangles of the loop, three edge numbers each, in the loop's direction.</summary>
        public List<int> Triangulate(List<int> loop)
        {
            best.Clear();
            bestCost = int.MaxValue;
            Search(loop, new List<int>(), 0);
            return new List<int>(best);
        }

        // Cuts off one triangle (an ear) at a time and tries every order: loops have at most seven corners.
        private void Search(List<int> loop, List<int> triangles, int cost)
        {
            if (cost >= bestCost) return;
            if (loop.Count == 3)
            {
                bestCost = cost;
                best.Clear();
                best.AddRange(triangles);
                best.AddRange(loop);
                return;
            }
            for (int i = 0; i < loop.Count; i++)
            {
                int before = loop[i];
                int ear = loop[(i + 1) % loop.Count];
                int after = loop[(i + 2) % loop.Count];
                if (ShareFace(before, after)) continue;
                var rest = new List<int>(loop);
                rest.Remove(ear);
                int diagonal = (midpoints[after] - midpoints[before]).sqrMagnitude;
                Search(rest, new List<int>(triangles) { before, ear, after }, cost + diagonal);
            }
        }

        private bool ShareFace(int a, int b)
        {
            Vector3Int p = midpoints[a];
            Vector3Int q = midpoints[b];
            return OnSameSide(p.x, q.x) || OnSameSide(p.y, q.y) || OnSameSide(p.z, q.z);
        }

        private static bool OnSameSide(int a, int b) => a == b && a != 1;
    }
}
