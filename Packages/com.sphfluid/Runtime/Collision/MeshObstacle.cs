using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Finds whether a point lies inside a closed mesh or close to any of its triangles. Triangles are binned by their
    /// (y, z) projection, so that a test along x looks at one bin.
    /// </summary>
    internal sealed class MeshObstacle
    {
        private const int MaxBins = 256;

        private readonly TriangleMesh mesh;
        private readonly int[] welded;
        private readonly Bounds bounds;
        private readonly List<int>[] bins;
        private readonly int binsY, binsZ;
        private readonly double perY, perZ;

        /// <summary>An obstacle of triangles in simulation space.</summary>
        public MeshObstacle(TriangleMesh mesh)
        {
            this.mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
            welded = mesh.Welded;
            bounds = mesh.Bounds;
            int side = Mathf.Clamp((int)Math.Sqrt(mesh.TriangleCount), 1, MaxBins);
            binsY = binsZ = side;
            perY = side / Math.Max(bounds.size.y, 1e-30);
            perZ = side / Math.Max(bounds.size.z, 1e-30);
            bins = new List<int>[binsY * binsZ];
            for (int t = 0; t < mesh.TriangleCount; t++) AddToBins(t);
        }

        /// <summary>Whether the point is inside the closed mesh or nearer than <paramref name="clearance"/> [m] to a triangle.</summary>
        public bool Covers(Vector3 point, float clearance) => Contains(point) || IsNear(point, clearance);

        /// <summary>
        /// Whether the surface winds outward round the point: the crossings of a ray along +x, each counted by its
        /// direction, sum to more than zero. A closed surface whose faces look inward holds no solid; an open mesh has no inside.
        /// </summary>
        public bool Contains(Vector3 point) => Winding(point) > 0;

        /// <summary>
        /// Times a closed surface winds round the point: 1 inside faces that look outward, −1 inside faces that look inward; 0 for an open
        /// mesh.
        /// </summary>
        public int Winding(Vector3 point) => mesh.IsClosed && bounds.Contains(point) ? Crossings(point) : 0;

        /// <summary>Sum of the crossings of a ray from the point along +x: +1 where it meets a back, −1 where it meets a front.</summary>
        public int Crossings(Vector3 point)
        {
            if (point.x > bounds.max.x) return 0;
            List<int> bin = bins[Index(BinY(point.y), BinZ(point.z))];
            if (bin == null) return 0;
            int sum = 0;
            foreach (int t in bin)
            {
                Corners(t, out Vector3 a, out Vector3 b, out Vector3 c);
                sum += TriangleMath.RayCrossing(point, a, b, c);
            }
            return sum;
        }

        /// <summary>Whether the point is nearer than <paramref name="clearance"/> [m] to a triangle.</summary>
        public bool IsNear(Vector3 point, float clearance) => Nearest(point, clearance) != null;

        /// <summary>The place on a triangle that is nearest to a point, nearer than a distance [m]; null where there is none.</summary>
        public Vector3? Nearest(Vector3 point, float within)
        {
            if (!(within > 0f) || !new Bounds(bounds.center, bounds.size + 2f * within * Vector3.one).Contains(point)) return null;
            Vector3? nearest = null;
            float square = within * within;
            for (int z = BinZ(point.z - within); z <= BinZ(point.z + within); z++)
                for (int y = BinY(point.y - within); y <= BinY(point.y + within); y++)
                {
                    Nearest(bins[Index(y, z)], point, within, ref square, ref nearest);
                }
            return nearest;
        }

        private void Nearest(List<int> bin, Vector3 point, float within, ref float square, ref Vector3? nearest)
        {
            if (bin == null) return;
            foreach (int t in bin)
            {
                Corners(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (Mathf.Min(a.x, Mathf.Min(b.x, c.x)) - within > point.x) continue;
                if (Mathf.Max(a.x, Mathf.Max(b.x, c.x)) + within < point.x) continue;
                Vector3 place = TriangleMath.ClosestPoint(point, a, b, c);
                if (!((place - point).sqrMagnitude < square)) continue;
                square = (place - point).sqrMagnitude;
                nearest = place;
            }
        }

        // A ray never slips between two triangles only if their common corners are the same to the bit.
        private void Corners(int t, out Vector3 a, out Vector3 b, out Vector3 c)
        {
            a = mesh.Vertices[welded[mesh.Indices[3 * t]]];
            b = mesh.Vertices[welded[mesh.Indices[3 * t + 1]]];
            c = mesh.Vertices[welded[mesh.Indices[3 * t + 2]]];
        }

        private void AddToBins(int t)
        {
            Corners(t, out Vector3 a, out Vector3 b, out Vector3 c);
            if (!AffineMath.IsFinite(a + b + c)) return;
            Vector3 min = Vector3.Min(a, Vector3.Min(b, c)), max = Vector3.Max(a, Vector3.Max(b, c));
            for (int z = BinZ(min.z); z <= BinZ(max.z); z++)
                for (int y = BinY(min.y); y <= BinY(max.y); y++) (bins[Index(y, z)] ??= new List<int>()).Add(t);
        }

        private int BinY(float y) => Bin((y - bounds.min.y) * perY, binsY);
        private int BinZ(float z) => Bin((z - bounds.min.z) * perZ, binsZ);
        private int Index(int y, int z) => z * binsY + y;

        private static int Bin(double coordinate, int count) => (int)Math.Min(Math.Max(Math.Floor(coordinate), 0.0), count - 1);
    }
}
