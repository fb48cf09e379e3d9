using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The viscous matrix I + dt L of the Standard method over all pairs in double precision, and the solution of its equations by
    /// conjugate gradients.
    /// </summary>
    internal sealed class ViscousReference
    {
        private readonly FluidSolverSettings settings;
        private readonly IReadOnlyList<FluidParticle> particles;
        private readonly double kick;
        private readonly List<(int Other, double Rate)>[] pairs;

        public ViscousReference(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double kick)
        {
            this.settings = settings;
            this.particles = particles;
            this.kick = kick;
            pairs = new List<(int, double)>[particles.Count];
            double radius = settings.SupportRadius, rest = settings.RestDensity;
            double factor = 2.0 * settings.Viscosity * settings.ParticleMass / (rest * rest * StandardReference.Response(settings));
            for (int i = 0; i < pairs.Length; i++)
            {
                pairs[i] = new List<(int, double)>();
                for (int j = 0; j < pairs.Length; j++)
                {
                    double r = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength).Length;
                    if (j != i && r < radius) pairs[i].Add((j, -factor * StandardReference.Slope(r, radius) / r));
                }
            }
        }

        /// <summary>The largest of 2 d + w: no eigenvalue of L is larger.</summary>
        public double Bound
        {
            get
            {
                double largest = 0.0;
                for (int i = 0; i < pairs.Length; i++)
                {
                    double sum = 0.0;
                    foreach ((int _, double rate) in pairs[i]) sum += 2.0 * rate;
                    Double3 wall = WallRates(i);
                    largest = Math.Max(largest, sum + Math.Max(wall.X, Math.Max(wall.Y, wall.Z)));
                }
                return largest;
            }
        }

        /// <summary>(I + dt L) v, walls at rest.</summary>
        public Double3[] Times(Double3[] v)
        {
            var result = new Double3[v.Length];
            for (int i = 0; i < v.Length; i++)
            {
                Double3 wall = WallRates(i);
                var sum = new Double3(wall.X * v[i].X, wall.Y * v[i].Y, wall.Z * v[i].Z);
                foreach ((int j, double rate) in pairs[i]) sum += rate * (v[i] - v[j]);
                result[i] = v[i] + kick * sum;
            }
            return result;
        }

        /// <summary>What the faces drag the particles to within the step, beside v*.</summary>
        public Double3 WallDrive(int i)
        {
            FluidBoundaries faces = settings.Boundaries;
            double[] low = FaceRates(i, -1.0), high = FaceRates(i, 1.0);
            return kick * (low[0] * (Double3)faces.LowX + low[1] * (Double3)faces.LowY + low[2] * (Double3)faces.LowZ +
                high[0] * (Double3)faces.HighX + high[1] * (Double3)faces.HighY + high[2] * (Double3)faces.HighZ);
        }

        /// <summary>v of (I + dt L) v = b.</summary>
        public Double3[] Solve(Double3[] b)
        {
            var x = new Double3[b.Length];
            Double3[] r = (Double3[])b.Clone(), p = (Double3[])b.Clone();
            double before = Product(r, r), start = before;
            for (int k = 0; k < 2000 && before > 1e-26 * start; k++)
            {
                Double3[] ap = Times(p);
                double alpha = before / Product(p, ap);
                for (int i = 0; i < x.Length; i++)
                {
                    x[i] += alpha * p[i];
                    r[i] -= alpha * ap[i];
                }
                double next = Product(r, r);
                for (int i = 0; i < x.Length; i++) p[i] = r[i] + next / before * p[i];
                before = next;
            }
            return x;
        }

        public static double Product(Double3[] a, Double3[] b)
        {
            double sum = 0.0;
            for (int i = 0; i < a.Length; i++) sum += a[i].X * b[i].X + a[i].Y * b[i].Y + a[i].Z * b[i].Z;
            return sum;
        }

        // Each face takes the velocity along its two axes.
        private Double3 WallRates(int i)
        {
            double[] low = FaceRates(i, -1.0), high = FaceRates(i, 1.0);
            double x = low[0] + high[0], y = low[1] + high[1], z = low[2] + high[2];
            return new Double3(y + z, x + z, x + y);
        }

        private double[] FaceRates(int i, double side)
        {
            var rates = new double[3];
            double viscosity = settings.Boundaries.Friction * settings.Viscosity / settings.RestDensity;
            for (int axis = 0; axis < 3; axis++)
            {
                if (settings.PeriodLength[axis] > 0f) continue;
                double d = Math.Max(0.5 * settings.DomainSize[axis] - side * particles[i].Position[axis], 0.25 * settings.Spacing);
                double radius = settings.SupportRadius, q = Math.Min(1.0, d / radius), u = 1.0 - q;
                rates[axis] = viscosity * 42.0 * Math.Pow(u, 5.0) * (1.0 - 1.5 * u + 4.0 / 7.0 * u * u) / (q * radius * radius);
            }
            return rates;
        }
    }
}
