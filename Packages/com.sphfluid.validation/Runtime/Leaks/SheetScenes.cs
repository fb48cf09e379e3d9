using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Level sheets across the whole domain, under liquid that falls on them or flows over them.</summary>
    internal static class SheetScenes
    {
        private const float Dx = LeakSceneEntry.Spacing;
        private static readonly Vector3 domain = new Vector3(16f, 30f, 16f) * Dx;

        /// <summary>
        /// Triangles from 0.05 to 50 dx, and needles of 0.05 by 50 dx, by lines that grow further apart from the middle on.
        /// </summary>
        public static LeakScene Sizes(double speed)
        {
            List<float> lines = Graded(0.05f * Dx, 50f * Dx, 1.5f);
            return Dropped(speed, LeakMeshes.Sheet(lines, lines, 0f));
        }

        /// <summary>
        /// A sheet with copies, turned copies, pieces within it that overlap, cracks of no width, and triangles without area.
        /// </summary>
        public static LeakScene Coplanar(double speed)
        {
            const int lines = 9;
            var random = new System.Random(7);
            float[] x = Enumerable.Range(0, lines).Select(k => (k - 4) * 2.7f * Dx).ToArray();
            List<Vector3> corners = LeakMeshes.Sheet(x, x, 0f).ToList();
            Vector3 At() => new Vector3((float)random.NextDouble() - 0.5f, 0f, (float)random.NextDouble() - 0.5f) * 16f * Dx;
            for (int k = 0; k < 40; k++)
            {
                Vector3 a = corners[6 * k], b = corners[6 * k + 1], c = corners[6 * k + 2], d = At(), e = At();
                corners.AddRange(new[] { a, b, c, a, c, b });                   // a copy, and one that faces the other side
                corners.AddRange(new[] { d, e, At() });                         // overlaps others
                corners.AddRange(new[] { d, e, 0.5f * (d + e), d, d, e, d, d, d }); // a line, an edge, a point
            }
            return Dropped(speed, corners.ToArray());
        }

        /// <summary>
        /// Liquid at rest below a sheet, liquid that flows above it, without friction: neither may drag the other. Periodic along x and z.
        /// </summary>
        public static LeakScene TwoSided(double speed)
        {
            Vector3 box = new Vector3(12f, 16f, 8f) * Dx;
            FluidSolverSettings settings = LeakSceneEntry.Water(box, box.y, speed);
            settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Z;
            float[] x = { -box.x, 0f, box.x }, z = { -box.z, 0f, box.z };
            List<Vector3> places = CaseLattice.Box(new Vector3Int(12, 8, 8), Dx, -0.5f * box);
            places.AddRange(CaseLattice.Box(new Vector3Int(12, 5, 8), Dx, Vector3.Scale(-0.5f * box, new Vector3(1f, 0f, 1f))));
            return new LeakScene
            {
                Settings = settings,
                Surface = LeakMeshes.Sheet(x, z, 0f),
                Frames = 60,
                Rests = true,
                Particles = CaseLattice.Particles(places, p => p.y > 0f ? (float)speed * Vector3.right : Vector3.zero),
            };
        }

        private static LeakScene Dropped(double speed, Vector3[] surface) => new LeakScene
        {
            Settings = LeakSceneEntry.Water(domain, 0.5f * domain.y, speed),
            Surface = surface,
            Frames = 90,
            Rests = true,
            Particles = CaseLattice.Particles(CaseLattice.Box(new Vector3Int(8, 10, 8), Dx, new Vector3(-4f, 1f, -4f) * Dx),
                _ => (float)speed * Vector3.down),
        };

        // Lines from the middle in both directions, each interval so many times the last, up to the largest.
        private static List<float> Graded(float smallest, float largest, float growth)
        {
            var right = new List<float> { 0.5f * smallest };
            for (float step = smallest * growth; step < largest * growth; step *= growth)
            {
                right.Add(right[right.Count - 1] + Mathf.Min(step, largest));
            }
            return right.Select(p => -p).Reverse().Concat(right).ToList();
        }
    }
}
