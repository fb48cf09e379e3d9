using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// For open surfaces: a particle that is seen after every step has gone straight in the surface's space, and its path must intersect no
    /// triangle. In double precision, and edges count: a path that only touches is an escape too.
    /// </summary>
    internal sealed class PathDetector : LeakDetector
    {
        // Of a volume over the product of its edges: signs nearer to zero count as touching.
        private const double Touching = 1e-12;

        private readonly Vector3[] corners;
        private readonly Bounds[] bounds;
        private readonly Vector3 period;
        private Vector3[] before;

        /// <param name="corners">Three a triangle [m].</param>
        /// <param name="period">Length of the domain along periodic axes [m], zero along others: paths across their faces go on at the
        /// other side.</param>
        public PathDetector(Vector3[] corners, Vector3 period)
        {
            this.corners = corners;
            this.period = period;
            bounds = new Bounds[corners.Length / 3];
            for (int t = 0; t < bounds.Length; t++)
            {
                bounds[t] = new Bounds(corners[3 * t], Vector3.zero);
                bounds[t].Encapsulate(corners[3 * t + 1]);
                bounds[t].Encapsulate(corners[3 * t + 2]);
            }
        }

        /// <inheritdoc/>
        public override bool NeedsSteps => true;

        /// <summary>
        /// Whether the closed segment from p to q intersects the closed triangle. A path within its plane does not count.
        /// </summary>
        public static bool Intersects(Vector3 p, Vector3 q, Vector3 a, Vector3 b, Vector3 c)
        {
            int s0 = Side(a, b, c, p), s1 = Side(a, b, c, q);
            if (s0 * s1 > 0 || s0 == 0 && s1 == 0) return false;
            int u = Side(p, q, a, b), v = Side(p, q, b, c), w = Side(p, q, c, a);
            return u >= 0 && v >= 0 && w >= 0 || u <= 0 && v <= 0 && w <= 0;
        }

        /// <inheritdoc/>
        protected override bool Passed(int particle, Vector3 place, bool first)
        {
            if (first) return false;
            Vector3 from = before[particle], to = from + Shortest(place - from);
            if (!(to.sqrMagnitude < float.PositiveInfinity)) return true;
            Vector3 low = Vector3.Min(from, to), high = Vector3.Max(from, to);
            for (int t = 0; t < bounds.Length; t++)
            {
                Vector3 min = bounds[t].min, max = bounds[t].max;
                bool near = min.x <= high.x && max.x >= low.x && min.y <= high.y && max.y >= low.y && min.z <= high.z && max.z >= low.z;
                if (near && Intersects(from, to, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2])) return true;
            }
            return false;
        }

        /// <inheritdoc/>
        protected override void Seen(Vector3[] places) => before = (Vector3[])places.Clone();

        private Vector3 Shortest(Vector3 path)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                if (period[axis] > 0f) path[axis] -= period[axis] * Mathf.Round(path[axis] / period[axis]);
            }
            return path;
        }

        // Sign of det(b − a, c − a, d − a).
        private static int Side(Vector3 a, Vector3 b, Vector3 c, Vector3 d)
        {
            double ux = (double)b.x - a.x, uy = (double)b.y - a.y, uz = (double)b.z - a.z;
            double vx = (double)c.x - a.x, vy = (double)c.y - a.y, vz = (double)c.z - a.z;
            double wx = (double)d.x - a.x, wy = (double)d.y - a.y, wz = (double)d.z - a.z;
            double volume = ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
            double size = (Math.Abs(ux) + Math.Abs(uy) + Math.Abs(uz)) * (Math.Abs(vx) + Math.Abs(vy) + Math.Abs(vz)) *
                (Math.Abs(wx) + Math.Abs(wy) + Math.Abs(wz));
            return Math.Abs(volume) <= Touching * size ? 0 : Math.Sign(volume);
        }
    }
}
