using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Fields that are known everywhere, for what turns a field into triangles.</summary>
    internal static class FieldStates
    {
        private const float Edge = 24f, SphereRadius = 10f, RingRadius = 8f, TubeRadius = 3f, NoiseRadius = 9f; // dx

        // Rise of the fields towards the inside, 1/dx: no value is cut off at 0 within 2.5 dx of the surface.
        private const float Slope = 0.2f;

        /// <summary>Distance from a sphere of radius 10 dx.</summary>
        public static SurfaceState Sphere(SurfaceScale scale) =>
            Known(scale, 4.0 / 3.0 * Math.PI * Math.Pow(SphereRadius, 3), p => p.magnitude - SphereRadius, p => p.normalized);

        /// <summary>Distance from a torus of radii 8 dx and 3 dx.</summary>
        public static SurfaceState Torus(SurfaceScale scale) => Known(scale, 2.0 * Math.PI * Math.PI * RingRadius * TubeRadius * TubeRadius,
            p => BodyStates.FromRing(p, RingRadius).magnitude - TubeRadius, p => BodyStates.FromRing(p, RingRadius).normalized);

        /// <summary>White noise in a ball of radius 9 dx: all 256 cases of a cube, and all that its neighbours can have.</summary>
        public static SurfaceState Noise(SurfaceScale scale)
        {
            var random = new System.Random(5);
            SurfaceState state = Of(scale);
            state.Volume = double.NaN;
            state.Field = p => p.magnitude < NoiseRadius * state.Spacing ? (float)random.NextDouble() : 0f;
            return state;
        }

        private static SurfaceState Known(SurfaceScale scale, double volume, Func<Vector3, float> distance, Func<Vector3, Vector3> normal)
        {
            SurfaceState state = Of(scale);
            float dx = state.Spacing;
            state.Volume = volume * Math.Pow(dx, 3);
            state.Field = p => Math.Max(0f, PolygoniserVariant.Iso - Slope * distance(p / dx));
            state.Normal = p => normal(p / dx);
            return state;
        }

        // Solvers want a particle.
        private static SurfaceState Of(SurfaceScale scale) => scale.Of(Edge * Vector3.one, new[] { 0.5f * Edge * Vector3.one });
    }
}
