using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Point and triangle tests.</summary>
    internal static class TriangleMath
    {
        /// <summary>
        /// Side of the (y, z) point of the directed line a→b: +1 left or −1 right, never 0. Both triangles at an edge
        /// evaluate it from the same ends in the same order, so that a ray through a mesh never slips between them and
        /// never counts both.
        /// </summary>
        public static int Side(Vector3 p, Vector3 a, Vector3 b)
        {
            bool swap = a.y > b.y || (a.y == b.y && a.z > b.z);
            Vector3 u = swap ? b : a, v = swap ? a : b;
            double cross = ((double)v.y - u.y) * ((double)p.z - u.z) - ((double)v.z - u.z) * ((double)p.y - u.y);
            return cross >= 0.0 != swap ? 1 : -1;
        }

        /// <summary>Twice the signed area of the (y, z) projection: the x component of Cross(b − a, c − a).</summary>
        public static double Area(Vector3 a, Vector3 b, Vector3 c) =>
            ((double)b.y - a.y) * ((double)c.z - a.z) - ((double)b.z - a.z) * ((double)c.y - a.y);

        /// <summary>
        /// Where the line along x through a point intersects a triangle: +1 where its face looks along +x, −1 where against it, 0 for a
        /// miss. A line through a mesh never slips between two triangles and never intersects both at their edge.
        /// </summary>
        public static int LineCrossing(Vector3 p, Vector3 a, Vector3 b, Vector3 c, out double x)
        {
            x = 0.0;
            int ab = Side(p, a, b), bc = Side(p, b, c), ca = Side(p, c, a);
            double nx = Area(a, b, c);
            if (ab != bc || bc != ca || nx == 0.0) return 0;
            double ny = ((double)b.z - a.z) * ((double)c.x - a.x) - ((double)b.x - a.x) * ((double)c.z - a.z);
            double nz = ((double)b.x - a.x) * ((double)c.y - a.y) - ((double)b.y - a.y) * ((double)c.x - a.x);
            x = a.x - (ny * ((double)p.y - a.y) + nz * ((double)p.z - a.z)) / nx;
            return ab;
        }

        /// <summary>Whether a line through a point crosses a triangle, edges included, and where.</summary>
        /// <param name="p">The point.</param>
        /// <param name="direction">Of the line, of any length.</param>
        /// <param name="a">A corner.</param>
        /// <param name="b">A corner.</param>
        /// <param name="c">A corner.</param>
        /// <param name="along">Of the crossing, from the point, over the direction's length.</param>
        public static bool LineCrosses(Vector3 p, Vector3 direction, Vector3 a, Vector3 b, Vector3 c, out float along)
        {
            Vector3 u = b - a, v = c - a, h = Vector3.Cross(direction, v), s = p - a, q = Vector3.Cross(s, u);
            float determinant = Vector3.Dot(u, h), x = Vector3.Dot(s, h), y = Vector3.Dot(direction, q);
            along = Vector3.Dot(v, q) / determinant;
            return determinant > 0f ? x >= 0f && y >= 0f && x + y <= determinant : determinant < 0f && x <= 0f && y <= 0f &&
                x + y >= determinant;
        }

        /// <summary>As <see cref="LineCrossing"/>, of the ray along +x from the point: +1 where it leaves what the face encloses.</summary>
        public static int RayCrossing(Vector3 p, Vector3 a, Vector3 b, Vector3 c)
        {
            int side = LineCrossing(p, a, b, c, out double hit);
            return hit > p.x ? side : 0;
        }

        /// <summary>
        /// Solid angle of a triangle over 4π, positive where its back is seen: tan(Ω/2) = a·(b × c)/(abc + (a·b)c + (b·c)a + (c·a)b)
        /// (A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", 1983).
        /// </summary>
        public static double SolidAngle(Vector3 p, Vector3 a, Vector3 b, Vector3 c)
        {
            (double x, double y, double z) u = ((double)a.x - p.x, (double)a.y - p.y, (double)a.z - p.z);
            (double x, double y, double z) v = ((double)b.x - p.x, (double)b.y - p.y, (double)b.z - p.z);
            (double x, double y, double z) w = ((double)c.x - p.x, (double)c.y - p.y, (double)c.z - p.z);
            double uv = u.x * v.x + u.y * v.y + u.z * v.z, vw = v.x * w.x + v.y * w.y + v.z * w.z, wu = w.x * u.x + w.y * u.y + w.z * u.z;
            double lu = Math.Sqrt(u.x * u.x + u.y * u.y + u.z * u.z), lv = Math.Sqrt(v.x * v.x + v.y * v.y + v.z * v.z),
                lw = Math.Sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
            double volume = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
            return Math.Atan2(volume, lu * lv * lw + uv * lw + vw * lu + wu * lv) / (2.0 * Math.PI);
        }

        /// <summary>Point of the triangle nearest to <paramref name="p"/> (C. Ericson, Real-Time Collision Detection, 5.1.5).</summary>
        public static Vector3 ClosestPoint(Vector3 p, Vector3 a, Vector3 b, Vector3 c)
        {
            Vector3 ab = b - a, ac = c - a, ap = p - a;
            float d1 = Vector3.Dot(ab, ap), d2 = Vector3.Dot(ac, ap);
            if (d1 <= 0f && d2 <= 0f) return a;

            Vector3 bp = p - b;
            float d3 = Vector3.Dot(ab, bp), d4 = Vector3.Dot(ac, bp);
            if (d3 >= 0f && d4 <= d3) return b;

            float vc = d1 * d4 - d3 * d2;
            if (vc <= 0f && d1 >= 0f && d3 <= 0f) return a + ab * (d1 / (d1 - d3));

            Vector3 cp = p - c;
            float d5 = Vector3.Dot(ab, cp), d6 = Vector3.Dot(ac, cp);
            if (d6 >= 0f && d5 <= d6) return c;

            float vb = d5 * d2 - d1 * d6;
            if (vb <= 0f && d2 >= 0f && d6 <= 0f) return a + ac * (d2 / (d2 - d6));

            float va = d3 * d6 - d5 * d4;
            if (va <= 0f && d4 - d3 >= 0f && d5 - d6 >= 0f) return b + (c - b) * ((d4 - d3) / (d4 - d3 + (d5 - d6)));

            float scale = 1f / (va + vb + vc);
            return a + ab * (vb * scale) + ac * (vc * scale);
        }

        /// <summary>
        /// Whether the triangle may intersect the axis-aligned box: their bounds overlap and the triangle's plane cuts the box.
        /// Never false for one that does.
        /// </summary>
        public static bool MayOverlap(Vector3 center, Vector3 halfExtents, Vector3 a, Vector3 b, Vector3 c)
        {
            Vector3 min = Vector3.Min(a, Vector3.Min(b, c)) - center, max = Vector3.Max(a, Vector3.Max(b, c)) - center;
            for (int axis = 0; axis < 3; axis++)
                if (min[axis] > halfExtents[axis] || max[axis] < -halfExtents[axis]) return false;
            Vector3 normal = Vector3.Cross(b - a, c - a);
            float reach = Mathf.Abs(normal.x) * halfExtents.x + Mathf.Abs(normal.y) * halfExtents.y + Mathf.Abs(normal.z) * halfExtents.z;
            float size = Mathf.Abs(normal.x * (a.x - center.x)) + Mathf.Abs(normal.y * (a.y - center.y)) +
                Mathf.Abs(normal.z * (a.z - center.z));
            return Mathf.Abs(Vector3.Dot(normal, a - center)) <= reach + 1e-5f * size;
        }
    }
}
