using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Pools and films, whose top should be a plane.</summary>
    internal static class PoolStates
    {
        // Air around free liquid and distance of what is looked at from its rims, dx: beyond the reach of every field.
        private const int Margin = 4, Rim = 5;

        // A film between two planes of the grid in cells of 0.5, 0.75 and 1 dx.
        private const float OffPlane = 0.18f;

        /// <summary>A block of a simple cubic lattice with normal jitter.</summary>
        /// <param name="scale">Sizes.</param>
        /// <param name="jitter">Standard deviation along each axis [dx].</param>
        public static SurfaceState Lattice(SurfaceScale scale, double jitter) =>
            Pool(scale, new Vector3Int(34, 10, 34), Block(new Vector3Int(34, 10, 34), jitter, 7));

        /// <summary>A block of loosely packed particles, as liquids have them.</summary>
        public static SurfaceState Packed(SurfaceScale scale)
        {
            var size = new Vector3Int(28, 10, 28);
            return Pool(scale, size, ParticlePacking.Box(size, 5));
        }

        /// <summary>
        /// A packed block that rises through the cells of the surface's grid, in 16 steps that cover all phases in cells of 0.5, 0.75 and 1
        /// dx.
        /// </summary>
        public static SurfaceState Rising(SurfaceScale scale)
        {
            const int steps = 16;
            const double step = 0.268;
            var size = new Vector3Int(19, 8, 19);
            Vector3[] places = ParticlePacking.Box(size, 5).ToArray();
            SurfaceState state = Pool(scale, size, places, 5f);
            double level = state.Level(0);
            state.Frames.Clear();
            for (int i = 0; i < steps; i++)
            {
                SurfaceScale.Add(state, places.Select(p => p + new Vector3(Margin, Margin + (float)(i * step), Margin)));
            }
            state.Level = frame => level + frame * step * SurfaceScale.Spacing;
            state.Normal = null;
            return state;
        }

        /// <summary>Liquid from wall to wall.</summary>
        public static SurfaceState Full(SurfaceScale scale)
        {
            var size = new Vector3Int(15, 15, 15);
            return scale.Of(size, Block(size, 0.05, 11));
        }

        /// <summary>One layer of particles.</summary>
        /// <param name="scale">Sizes.</param>
        /// <param name="jitter">Standard deviation along each axis [dx].</param>
        public static SurfaceState Film(SurfaceScale scale, double jitter)
        {
            var size = new Vector3Int(25, 1, 25);
            SurfaceState state = Pool(scale, size, Block(size, jitter, 9).Select(p => p + OffPlane * Vector3.up));
            state.Level = null;
            state.Normal = null;
            return state;
        }

        private static SurfaceState Pool(SurfaceScale scale, Vector3Int size, IEnumerable<Vector3> places, float above = 0f)
        {
            Vector3 domain = size + 2 * Margin * Vector3Int.one + above * Vector3.up;
            SurfaceState state = scale.Of(domain, places.Select(p => p + Margin * Vector3.one));
            SurfaceScale.LookAt(state, (Margin + Rim) * Vector2.one, new Vector2(Margin + size.x - Rim, Margin + size.z - Rim));
            double level = SurfaceScale.Height(state, Margin + size.y);
            Rect top = state.Top.Value;
            state.Level = _ => level;
            state.Normal = p => top.Contains(new Vector2(p.x, p.z)) && Math.Abs(p.y - level) < SurfaceScale.Spacing ? Vector3.up
                : Vector3.zero;
            return state;
        }

        private static List<Vector3> Block(Vector3Int size, double jitter, int seed)
        {
            List<Vector3> places = CaseLattice.Box(size, 1.0, Vector3.zero);
            CaseLattice.Jitter(places, jitter, seed, float.MaxValue * Vector3.one);
            return places;
        }
    }
}
