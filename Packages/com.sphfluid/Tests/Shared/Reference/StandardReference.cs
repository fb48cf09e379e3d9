using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The Standard method's sums by all pairs in double precision; walls by numerical quadrature of the kernel's slices.
    /// </summary>
    public static class StandardReference
    {
        /// <summary>Wendland's C2 kernel [1/m³].</summary>
        public static double Kernel(double r, double radius)
        {
            double q = r / radius;
            return q < 1.0 ? 21.0 / (2.0 * Math.PI * radius * radius * radius) * Math.Pow(1.0 - q, 4.0) * (4.0 * q + 1.0) : 0.0;
        }

        /// <summary>dW/dr [1/m⁴].</summary>
        public static double Slope(double r, double radius)
        {
            const double step = 1e-5;
            return (Kernel(r + step * radius, radius) - Kernel(Math.Abs(r - step * radius), radius)) / (2.0 * step * radius);
        }

        /// <summary>Integral of W over the plane at a distance z R, times R: midpoint sums over rings.</summary>
        public static double Slice(double z)
        {
            const int rings = 400;
            double sum = 0.0, reach = z < 1.0 ? Math.Sqrt(1.0 - z * z) : 0.0;
            for (int i = 0; i < rings; i++)
            {
                double a = (i + 0.5) * reach / rings;
                sum += 2.0 * Math.PI * a * Kernel(Math.Sqrt(a * a + z * z), 1.0) * reach / rings;
            }
            return sum;
        }

        /// <summary>Density that a plane wall adds, over ρ0: the particle's mirror layers.</summary>
        public static double Mirror(double distance, double radius, double spacing)
        {
            double sum = 0.0;
            for (int layer = 0; layer < 3; layer++) sum += Slice((2.0 * Math.Max(0.0, distance) + layer * spacing) / radius);
            return sum * spacing / radius;
        }

        /// <summary>Density of the six faces over ρ0.</summary>
        public static double Walls(Double3 p, in FluidSolverSettings settings)
        {
            Vector3 half = 0.5f * settings.DomainSize, period = settings.PeriodLength;
            double open = 1.0;
            double[] low = { half.x + p.X, half.y + p.Y, half.z + p.Z }, high = { half.x - p.X, half.y - p.Y, half.z - p.Z };
            for (int axis = 0; axis < 3; axis++)
            {
                if (period[axis] > 0f) continue;
                int faces = (int)settings.Boundaries.Open >> 2 * axis;
                if ((faces & 1) == 0) open *= 1.0 - Mirror(low[axis], settings.SupportRadius, settings.Spacing);
                if ((faces & 2) == 0) open *= 1.0 - Mirror(high[axis], settings.SupportRadius, settings.Spacing);
            }
            return 1.0 - open;
        }

        /// <summary>By how much of a compression the density by summation of a cubic lattice grows: compressed by ±10⁻⁴.</summary>
        public static double Response(in FluidSolverSettings settings)
        {
            const double strain = 1e-4;
            double radius = settings.SupportRadius, dx = settings.Spacing;
            double Sum(double scale)
            {
                int reach = (int)Math.Ceiling(radius / dx) + 1;
                double sum = 0.0;
                for (int z = -reach; z <= reach; z++)
                    for (int y = -reach; y <= reach; y++)
                        for (int x = -reach; x <= reach; x++) sum += Kernel(dx * new Double3(scale * x, y, z).Length, radius);
                return sum;
            }
            return (Sum(1.0 - strain) - Sum(1.0 + strain)) / (2.0 * strain * Sum(1.0));
        }

        /// <summary>Density as the equation of state sees it [kg/m³].</summary>
        public static double Density(IReadOnlyList<FluidParticle> particles, int i, in FluidSolverSettings settings)
        {
            double sum = settings.RestDensity * Walls(particles[i].Position, settings);
            for (int j = 0; j < particles.Count; j++)
            {
                sum += settings.ParticleMass * Kernel(ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength).Length,
                    settings.SupportRadius);
            }
            return settings.RestDensity + (sum - settings.RestDensity) / Response(settings);
        }

        /// <summary>What parts two particles nearer than 0.6 dx, d and v those of one seen from the other [m/s²].</summary>
        public static Double3 Parting(Double3 d, Double3 v, in FluidSolverSettings settings)
        {
            double dx = settings.Spacing, c = settings.SoundSpeed, r2 = d.X * d.X + d.Y * d.Y + d.Z * d.Z;
            double weight = Math.Max(0.0, Math.Min(1.0, 4.0 - 4.0 * r2 / (0.6 * dx * 0.6 * dx)));
            double approach = Math.Max(0.0, -(d.X * v.X + d.Y * v.Y + d.Z * v.Z));
            return weight / (dx * dx) * (5e-4 * c * c + 1.7 * c / dx * approach) * d;
        }

        /// <summary>Acceleration without contact, of a step of c dt/dx ≤ 1 [m/s²].</summary>
        public static Double3 Acceleration(IReadOnlyList<FluidParticle> particles, IReadOnlyList<double> density, int i,
            in FluidSolverSettings settings)
        {
            double radius = settings.SupportRadius, rest = settings.RestDensity, c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
            double Term(int k) => Math.Max(0.0, c2 * (density[k] - rest)) / (density[k] * density[k]);
            Double3 sum = new Double3(), parting = new Double3();
            for (int j = 0; j < particles.Count; j++)
            {
                Double3 d = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength);
                if (j == i || d.Length >= radius) continue;
                parting += Parting(d, (Double3)particles[i].VelT0 - particles[j].VelT0, settings);
                double slope = settings.ParticleMass * Slope(d.Length, radius) / d.Length;
                sum -= slope * (Term(i) + Term(j)) * d;
                sum += 2.0 * settings.Viscosity / (rest * rest) * slope * ((Double3)particles[i].VelT0 - particles[j].VelT0);
            }
            double step = 1e-4 * settings.Spacing;
            Double3 p = particles[i].Position;
            var gradient = new Double3(
                Walls(p + new Double3(step, 0, 0), settings) - Walls(p - new Double3(step, 0, 0), settings),
                Walls(p + new Double3(0, step, 0), settings) - Walls(p - new Double3(0, step, 0), settings),
                Walls(p + new Double3(0, 0, step), settings) - Walls(p - new Double3(0, 0, step), settings));
            return settings.Gravity + parting + 1.0 / Response(settings) * (sum - rest * Term(i) / (2.0 * step) * gradient);
        }
    }
}
