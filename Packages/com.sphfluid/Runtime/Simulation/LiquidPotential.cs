using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The potential of gravity and body force, Φ = −g·x + ½ ω² (x − centre)²: liquid at speed v can reach √(v² + 2 (Φ − lowest Φ)).
    /// </summary>
    internal static class LiquidPotential
    {
        /// <summary>The lowest in the domain box [m²/s²].</summary>
        public static double Lowest(in FluidSolverSettings settings)
        {
            double lowest = 0.0;
            for (int axis = 0; axis < 3; axis++)
            {
                double gravity = settings.Gravity[axis], rate = settings.BodyForce.RateSquared[axis];
                double centre = settings.BodyForce.Centre[axis], half = 0.5 * settings.DomainSize[axis];
                double least = Math.Min(At(-half, gravity, rate, centre), At(half, gravity, rate, centre));
                double rest = rate > 0.0 ? centre + gravity / rate : 0.0; // where both forces balance
                if (rate > 0.0 && Math.Abs(rest) < half) least = Math.Min(least, At(rest, gravity, rate, centre));
                lowest += least;
            }
            return lowest;
        }

        /// <summary>
        /// Depth of particles that rest [m]: their volume over the domain's cross-section across gravity, so the least where solids stand
        /// in the liquid; 0 without gravity.
        /// </summary>
        public static double DepthAtRest(Vector3 domainSize, double spacing, Vector3 gravity, long count)
        {
            Vector3 up = gravity.normalized;
            double height = Math.Abs(up.x) * domainSize.x + Math.Abs(up.y) * domainSize.y + Math.Abs(up.z) * domainSize.z;
            return count * spacing * spacing * spacing / ((double)domainSize.x * domainSize.y * domainSize.z) * height;
        }

        /// <summary>Largest acceleration in the domain box [m/s²].</summary>
        public static double Acceleration(in FluidSolverSettings settings)
        {
            double squares = 0.0;
            for (int axis = 0; axis < 3; axis++)
            {
                double reach = 0.5 * settings.DomainSize[axis] + Math.Abs(settings.BodyForce.Centre[axis]);
                double force = Math.Abs(settings.BodyForce.RateSquared[axis]) * reach + Math.Abs(settings.Gravity[axis]);
                squares += force * force;
            }
            return Math.Sqrt(squares);
        }

        /// <summary>
        /// Longest period in which the liquid swings in the domain [s]: a sloshing wave of half its length along the domain's longest side
        /// across gravity, ω² = g k tanh(k D), and the body force's own.
        /// </summary>
        /// <param name="settings">The liquid.</param>
        /// <param name="depth">Its depth D at rest [m].</param>
        public static double LongestPeriod(in FluidSolverSettings settings, double depth)
        {
            double period = 0.0, gravity = settings.Gravity.magnitude;
            if (gravity > 0.0)
            {
                Vector3 up = settings.Gravity.normalized;
                double side = settings.Spacing;
                for (int axis = 0; axis < 3; axis++)
                {
                    side = Math.Max(side, settings.DomainSize[axis] * Math.Sqrt(Math.Max(0.0, 1.0 - (double)up[axis] * up[axis])));
                }
                double k = Math.PI / side;
                period = 2.0 * Math.PI / Math.Sqrt(gravity * k * Math.Tanh(k * Math.Max(depth, settings.Spacing)));
            }
            for (int axis = 0; axis < 3; axis++)
            {
                double rate = settings.BodyForce.RateSquared[axis];
                if (rate > 0.0) period = Math.Max(period, 2.0 * Math.PI / Math.Sqrt(rate));
            }
            return period;
        }

        private static double At(double x, double gravity, double rate, double centre) =>
            0.5 * rate * (x - centre) * (x - centre) - gravity * x;
    }
}
