using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Momentum, speed and compression of a snapshot, summed in double precision; and what else a criterion asks of one.</summary>
    internal readonly struct LiquidMotion
    {
        private LiquidMotion(double3 momentum, double scale, double maxSpeed, double compression)
        {
            Momentum = momentum;
            MomentumScale = scale;
            MaxSpeed = maxSpeed;
            MeanCompression = compression;
        }

        /// <summary>Σ m v [kg m/s].</summary>
        public double3 Momentum { get; }

        /// <summary>Σ m |v| [kg m/s].</summary>
        public double MomentumScale { get; }

        /// <summary>Largest speed [m/s]; not a number when a velocity is not.</summary>
        public double MaxSpeed { get; }

        /// <summary>Mean of max(0, ρ/ρ0 − 1).</summary>
        public double MeanCompression { get; }

        public static LiquidMotion Of(FluidSnapshot state, in FluidSolverSettings settings)
        {
            double scale = 0.0, maxSpeed = 0.0, compression = 0.0;
            double3 momentum = double3.zero;
            for (int i = 0; i < state.Count; i++)
            {
                double3 v = (float3)state.Velocities[i];
                double speed = math.length(v);
                scale += settings.ParticleMass * speed;
                momentum += settings.ParticleMass * v;
                maxSpeed = speed <= maxSpeed ? maxSpeed : speed; // not a number stays
                compression += Math.Max(0.0, state.Densities[i] / (double)settings.RestDensity - 1.0);
            }
            return new LiquidMotion(momentum, scale, maxSpeed, compression / Math.Max(1, state.Count));
        }

        /// <summary>
        /// Height of a column [m]: half a spacing above the median of its highest layer's worth of particles, so that a few that fly do not
        /// count.
        /// </summary>
        /// <param name="state">The particles.</param>
        /// <param name="settings">Domain and spacing.</param>
        /// <param name="depth">Height at rest density [m], from which the number of layers follows.</param>
        public static double ColumnHeight(FluidSnapshot state, in FluidSolverSettings settings, double depth)
        {
            var heights = new double[state.Count];
            for (int i = 0; i < heights.Length; i++) heights[i] = state.LocalPositions[i].y + 0.5 * settings.DomainSize.y;
            Array.Sort(heights);
            int layers = Math.Max(1, (int)Math.Round(depth / settings.Spacing));
            int layer = Math.Max(1, state.Count / layers);
            return heights[heights.Length - 1 - layer / 2] + 0.5 * settings.Spacing;
        }

        /// <summary>Share of the particles with another one nearer than a distance, across the faces of periodic axes too.</summary>
        /// <param name="state">The particles.</param>
        /// <param name="settings">Domain and periodic axes.</param>
        /// <param name="distance">The distance [m].</param>
        public static double ClosePairs(FluidSnapshot state, in FluidSolverSettings settings, double distance)
        {
            Vector3[] positions = WithImages(state.LocalPositions, settings, (float)distance);
            var cells = new CellLists(positions, (float)distance);
            int near = 0;
            for (int i = 0; i < state.Count; i++)
            {
                if (cells.CountWithin(positions, i, (float)distance) > 0) near++;
            }
            return near / (double)Math.Max(1, state.Count);
        }

        // What lies within the distance of a periodic face is there once more beyond the other one.
        private static Vector3[] WithImages(Vector3[] positions, in FluidSolverSettings settings, float distance)
        {
            var all = new List<Vector3>(positions);
            for (int axis = 0; axis < 3; axis++)
            {
                float length = settings.PeriodLength[axis];
                for (int i = 0, count = all.Count; length > 0f && i < count; i++)
                {
                    Vector3 image = all[i];
                    if (Mathf.Abs(image[axis]) <= 0.5f * length - distance) continue;
                    image[axis] -= Mathf.Sign(image[axis]) * length;
                    all.Add(image);
                }
            }
            return all.ToArray();
        }
    }
}
