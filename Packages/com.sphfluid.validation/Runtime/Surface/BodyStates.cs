using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Balls, a ring, drops and a splash in air.</summary>
    internal static class BodyStates
    {
        private const double SphereRadius = 8.0, RingRadius = 8.0, TubeRadius = 3.0, SmallRadius = 5.0;
        private const double Jitter = 0.05;

        /// <summary>A ball of radius 8 dx, cut from a lattice.</summary>
        public static SurfaceState Sphere(SurfaceScale scale)
        {
            SurfaceState state =
                scale.Of(24f * Vector3.one, Jittered(CaseLattice.Ball(SphereRadius, 1.0), 3).Select(p => p + 12f * Vector3.one));
            state.Normal = p => p.normalized;
            return state;
        }

        /// <summary>A ring of radius 8 dx with a tube of radius 3 dx.</summary>
        public static SurfaceState Torus(SurfaceScale scale)
        {
            List<Vector3> places = CaseLattice.Ball(RingRadius + TubeRadius, 1.0)
                .Where(p => FromRing(p, RingRadius).magnitude <= TubeRadius).ToList();
            SurfaceState state = scale.Of(new Vector3(30f, 15f, 30f), Jittered(places, 4).Select(p => p + new Vector3(15f, 7.5f, 15f)));
            state.Normal = p => FromRing(p, RingRadius * SurfaceScale.Spacing).normalized;
            return state;
        }

        /// <summary>Two balls of radius 5 dx, nearer to each other from frame to frame.</summary>
        public static SurfaceState TwoSpheres(SurfaceScale scale)
        {
            const float widest = 1.6f, step = 0.1f;
            const int frames = 15;
            List<Vector3> ball = CaseLattice.Ball(SmallRadius, 1.0);
            SurfaceState state = scale.Of(new Vector3(30f, 18f, 18f), ball.Concat(ball));
            state.Frames.Clear();
            state.Gaps = new double[frames];
            for (int i = 0; i < frames; i++)
            {
                // The outermost particles lie half a spacing inside the ball that the lattice stands for.
                float gap = widest - i * step;
                state.Gaps[i] = gap;
                var left = new Vector3(9f, 9f, 9f);
                Vector3 right = left + (2f * (float)SmallRadius + gap) * Vector3.right;
                SurfaceScale.Add(state, ball.Select(p => p + left).Concat(ball.Select(p => p + right)));
            }
            return state;
        }

        /// <summary>48 particles without neighbours, each elsewhere in its cell of the surface's grid.</summary>
        public static SurfaceState Drops(SurfaceScale scale)
        {
            var random = new System.Random(1);
            List<Vector3> places = CaseLattice.Box(new Vector3Int(4, 3, 4), 6.0, 3f * Vector3.one);
            for (int i = 0; i < places.Count; i++)
            {
                places[i] += new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble());
            }
            SurfaceState state = scale.Of(new Vector3(30f, 24f, 30f), places);
            state.Drops = state.Frames[0];
            return state;
        }

        /// <summary>A shallow pool, a crown above it, and drops.</summary>
        public static SurfaceState Splash(SurfaceScale scale)
        {
            const int crown = 700, drops = 250;
            var random = new System.Random(3);
            List<Vector3> places = CaseLattice.Box(new Vector3Int(24, 5, 24), 1.0, Vector3.zero);
            CaseLattice.Jitter(places, 0.15, 3, float.MaxValue * Vector3.one);
            for (int i = 0; i < crown; i++)
            {
                double angle = 2.0 * Math.PI * random.NextDouble(), radius = 5.0 + 0.7 * CaseLattice.Normal(random),
                    height = 5.0 + 3.0 * Math.Abs(CaseLattice.Normal(random));
                places.Add(new Vector3((float)(12.0 + radius * Math.Cos(angle)), (float)height, (float)(12.0 + radius * Math.Sin(angle))));
            }
            for (int i = 0; i < drops; i++)
            {
                places
                    .Add(new Vector3(24f * (float)random.NextDouble(), 5f + 12f * (float)random.NextDouble(),
                        24f * (float)random.NextDouble()));
            }
            SurfaceState state = scale.Of(new Vector3(33f, 27f, 33f), places.Select(p => p + 4.5f * Vector3.one));
            state.Drops = Lone(state.Frames[0], state.Settings.SupportRadius);
            return state;
        }

        /// <summary>500 particles at one point.</summary>
        public static SurfaceState Coincident(SurfaceScale scale)
        {
            SurfaceState state = scale.Of(12f * Vector3.one, Enumerable.Repeat(new Vector3(6.3f, 5.9f, 6.1f), 500));
            state.Volume = double.NaN;
            return state;
        }

        // From the nearest point of a ring about the y axis.
        internal static Vector3 FromRing(Vector3 p, double radius)
        {
            var across = new Vector3(p.x, 0f, p.z);
            Vector3 outwards = across == Vector3.zero ? Vector3.right : across.normalized; // on the axis all of the ring is as near
            return p - (float)radius * outwards;
        }

        private static Vector3[] Lone(Vector3[] positions, float reach)
        {
            var cells = new CellLists(positions, reach);
            return Enumerable.Range(0, positions.Length).Where(i => cells.CountWithin(positions, i, reach) == 0)
                .Select(i => positions[i]).ToArray();
        }

        private static List<Vector3> Jittered(List<Vector3> places, int seed)
        {
            CaseLattice.Jitter(places, Jitter, seed, float.MaxValue * Vector3.one);
            return places;
        }
    }
}
