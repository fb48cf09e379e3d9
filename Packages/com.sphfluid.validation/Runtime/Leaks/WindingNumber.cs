using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The generalised winding number of triangles round a point, in double precision: the sum of their solid angles over 4π
    /// (A. van Oosterom and J. Strackee, The Solid Angle of a Plane Triangle, 1983). 1 inside a closed surface, 0 outside; fractions
    /// near the rim of an open one. It shares nothing with the ray test of the solver's own obstacles.
    /// </summary>
    internal sealed class WindingNumber
    {
        private readonly IReadOnlyList<Vector3> corners;

        /// <param name="corners">Three a triangle; Cross(B − A, C − A) outward.</param>
        public WindingNumber(IReadOnlyList<Vector3> corners) => this.corners = corners;

        /// <summary>Whether more of the surface winds round the point than not.</summary>
        public bool Contains(Vector3 point) => At(point) > 0.5;

        /// <summary>The number at a point.</summary>
        public double At(Vector3 point)
        {
            double sum = 0.0;
            for (int i = 0; i < corners.Count; i += 3) sum += SolidAngle(corners[i], corners[i + 1], corners[i + 2], point);
            return sum / (4.0 * Math.PI);
        }

        /// <summary>Distance from a point to the nearest triangle [m].</summary>
        public float DistanceTo(Vector3 point)
        {
            float nearest = float.PositiveInfinity;
            for (int i = 0; i < corners.Count; i += 3)
            {
                nearest = Mathf.Min(nearest, CpuTriangle.Separation(point, corners[i], corners[i + 1], corners[i + 2]).magnitude);
            }
            return nearest;
        }

        // tan(Ω/2) = det(a, b, c) / (abc + (a·b)c + (a·c)b + (b·c)a), positive where the front is seen from inside.
        private static double SolidAngle(Vector3 a, Vector3 b, Vector3 c, Vector3 p)
        {
            double ax = (double)a.x - p.x, ay = (double)a.y - p.y, az = (double)a.z - p.z;
            double bx = (double)b.x - p.x, by = (double)b.y - p.y, bz = (double)b.z - p.z;
            double cx = (double)c.x - p.x, cy = (double)c.y - p.y, cz = (double)c.z - p.z;
            double la = Math.Sqrt(ax * ax + ay * ay + az * az), lb = Math.Sqrt(bx * bx + by * by + bz * bz),
                lc = Math.Sqrt(cx * cx + cy * cy + cz * cz);
            double volume = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
            double scale = la * lb * lc + (ax * bx + ay * by + az * bz) * lc + (ax * cx + ay * cy + az * cz) * lb +
                (bx * cx + by * cy + bz * cz) * la;
            return 2.0 * Math.Atan2(volume, scale);
        }
    }
}
