using System;
using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>
    /// The share of a particle's kernel behind triangles, by sums over pieces of their area in double precision: a piece dA whose normal is
    /// at θ to the ray adds Q(s) cos θ dA/s², Q(s) = (Λ(s) − s Λ′(s))/2π, so that a whole plane adds Λ(d).
    /// </summary>
    public static class ShadowReference
    {
        /// <summary>Below this many spacings the profile goes on with the slope that it has there.</summary>
        public const double SteepestAt = 0.51;

        /// <summary>Λ: what a whole plane adds.</summary>
        /// <param name="d">Distance [m].</param>
        /// <param name="radius">Support radius [m].</param>
        /// <param name="spacing">dx [m].</param>
        public static double Plane(double d, double radius, double spacing) => Profile(d, radius, spacing).value;

        /// <summary>The share behind triangles that are seen from the side of their normals.</summary>
        /// <param name="x">Where the particle is [m].</param>
        /// <param name="corners">Three a triangle; the normal is cross(b − a, c − a).</param>
        /// <param name="radius">Support radius [m].</param>
        /// <param name="spacing">dx [m].</param>
        public static double Share(Double3 x, IReadOnlyList<Double3> corners, double radius, double spacing)
        {
            double sum = 0.0;
            for (int t = 0; t < corners.Count; t += 3)
                if (Double3.Dot(x - corners[t], Double3.Cross(corners[t + 1] - corners[t], corners[t + 2] - corners[t])) > 0.0)
                {
                    sum += Piece(x, corners[t], corners[t + 1], corners[t + 2], radius, spacing);
                }
            return sum;
        }

        /// <summary>Its gradient [1/m], by differences.</summary>
        public static Double3 Gradient(Double3 x, IReadOnlyList<Double3> corners, double radius, double spacing)
        {
            double step = 2e-3 * spacing;
            double Along(double u, double v, double w) => Share(x + new Double3(u, v, w), corners, radius, spacing) -
                Share(x - new Double3(u, v, w), corners, radius, spacing);
            return 0.5 / step * new Double3(Along(step, 0, 0), Along(0, step, 0), Along(0, 0, step));
        }

        private static double Piece(Double3 x, Double3 a, Double3 b, Double3 c, double radius, double spacing)
        {
            Double3 middle = (a + b + c) / 3.0;
            double ab = (b - a).Length, bc = (c - b).Length, ca = (a - c).Length, longest = Math.Max(ab, Math.Max(bc, ca)),
                s = (middle - x).Length;
            if (s - longest > 0.5 * radius) return 0.0;
            if (longest > 0.12 * s)
            {
                if (longest == ab) return Piece(x, a, 0.5 * (a + b), c, radius, spacing) + Piece(x, 0.5 * (a + b), b, c, radius, spacing);
                if (longest == bc) return Piece(x, a, b, 0.5 * (b + c), radius, spacing) + Piece(x, a, 0.5 * (b + c), c, radius, spacing);
                return Piece(x, a, b, 0.5 * (c + a), radius, spacing) + Piece(x, 0.5 * (c + a), b, c, radius, spacing);
            }
            (double value, double slope) = Profile(s, radius, spacing);
            Double3 area = 0.5 * Double3.Cross(b - a, c - a);
            return (value - s * slope) / (2.0 * Math.PI) * Double3.Dot(x - middle, area) / (s * s * s);
        }

        // By differences of the quadrature it would take minutes: w(z) = 21 (1/14 − z²/2 + 5 z⁴/2 − 4 z⁵ + 5 z⁶/2 − 4 z⁷/7) is checked
        // against that elsewhere.
        private static (double value, double slope) Profile(double d, double radius, double spacing)
        {
            double least = SteepestAt * spacing, at = Math.Max(d, least), value = 0.0, slope = 0.0;
            for (int layer = 0; layer < 3; layer++)
            {
                double z = Math.Min((2.0 * at + layer * spacing) / radius, 1.0);
                value += 21.0 *
                    (1.0 / 14.0 - z * z / 2.0 + 5.0 * Math.Pow(z, 4) / 2.0 - 4.0 * Math.Pow(z, 5) +
                        5.0 * Math.Pow(z, 6) / 2.0 - 4.0 * Math.Pow(z, 7) / 7.0);
                slope -= 42.0 / radius * z * Math.Pow(1.0 - z, 4) * (4.0 * z + 1.0);
            }
            value *= spacing / radius;
            slope *= spacing / radius;
            return (value + slope * Math.Min(d - least, 0.0), slope);
        }
    }
}
