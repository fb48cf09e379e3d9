using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Surfaces of one triangle's thickness, as corners [m], three a triangle; outward by the left-hand rule where they are round.
    /// </summary>
    internal static class LeakMeshes
    {
        /// <summary>The walls between two rings about the y axis.</summary>
        /// <param name="low">Radius of the lower ring at a corner [m].</param>
        /// <param name="high">Radius of the upper ring [m].</param>
        /// <param name="bottom">Height of the lower ring [m].</param>
        /// <param name="top">Height of the upper ring [m].</param>
        /// <param name="sides">Corners of a ring.</param>
        public static IEnumerable<Vector3> Skirt(Func<int, float> low, Func<int, float> high, float bottom, float top, int sides) =>
            Enumerable.Range(0, sides).SelectMany(k =>
            {
                Vector3 a = Ring(low, k, sides, bottom), b = Ring(high, k, sides, top);
                Vector3 c = Ring(high, k + 1, sides, top), d = Ring(low, k + 1, sides, bottom);
                return new[] { a, b, c, a, c, d };
            });

        /// <summary>The face of a ring, looking up or down.</summary>
        public static IEnumerable<Vector3> Disc(float radius, float height, int sides, bool up) =>
            Enumerable.Range(0, sides).SelectMany(k =>
            {
                Vector3 a = Ring(_ => radius, k, sides, height), b = Ring(_ => radius, k + 1, sides, height), centre = height * Vector3.up;
                return up ? new[] { centre, b, a } : new[] { centre, a, b };
            });

        /// <summary>A cup about the y axis, its bottom at zero.</summary>
        public static Vector3[] Cup(float radius, float height, int sides, bool lid)
        {
            IEnumerable<Vector3> cup = Skirt(_ => radius, _ => radius, 0f, height, sides).Concat(Disc(radius, 0f, sides, false));
            return (lid ? cup.Concat(Disc(radius, height, sides, true)) : cup).ToArray();
        }

        /// <summary>The corners of a mesh.</summary>
        public static Vector3[] Corners(TriangleMesh mesh) => mesh.Indices.Select(i => mesh.Vertices[i]).ToArray();

        /// <summary>A level sheet through all lines of x and z [m].</summary>
        public static Vector3[] Sheet(IReadOnlyList<float> x, IReadOnlyList<float> z, float height)
        {
            var corners = new List<Vector3>();
            for (int k = 0; k + 1 < z.Count; k++)
                for (int i = 0; i + 1 < x.Count; i++)
                {
                    Vector3 a = new Vector3(x[i], height, z[k]), b = new Vector3(x[i], height, z[k + 1]);
                    Vector3 c = new Vector3(x[i + 1], height, z[k + 1]), d = new Vector3(x[i + 1], height, z[k]);
                    corners.AddRange(new[] { a, b, c, a, c, d });
                }
            return corners.ToArray();
        }

        /// <summary>The places inside a closed surface, on a lattice, that keep a distance from it.</summary>
        /// <param name="surface">Corners [m].</param>
        /// <param name="spacing">dx [m].</param>
        /// <param name="below">Height that they stay below [m].</param>
        public static List<Vector3> Fill(Vector3[] surface, float spacing, float below)
        {
            TriangleMesh obstacle = TriangleMesh.FromCorners(surface);
            Vector3 low = surface.Aggregate(Vector3.Min), high = surface.Aggregate(Vector3.Max);
            // Half a spacing from the lowest point, as liquid lies on a floor.
            Vector3Int counts = Vector3Int.CeilToInt((high - low) / spacing);
            return CaseLattice.Box(counts, spacing, low)
                .Where(p => p.y < below && obstacle.Contains(p) && !obstacle.IsNear(p, 0.45f * spacing)).ToList();
        }

        private static Vector3 Ring(Func<int, float> radius, int k, int sides, float height)
        {
            float angle = 2f * Mathf.PI * (k % sides) / sides, r = radius(k % sides);
            return new Vector3(r * Mathf.Cos(angle), height, r * Mathf.Sin(angle));
        }
    }
}
