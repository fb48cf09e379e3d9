using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Equations (10) to (17) of the thesis with the documented corrections, by brute force over all pairs.
    /// Written from the equations as W(r), not from the shaders' factored form.
    /// </summary>
    public static class ThesisReference
    {
        /// <summary>Equation (12).</summary>
        public static double Poly6(double r, double h)
        {
            return r < h ? 315.0 / (64.0 * Math.PI * Math.Pow(h, 9)) * Math.Pow(h * h - r * r, 3) : 0.0;
        }

        /// <summary>Derivative along r of equation (14), W = 15 / (π h⁶) (h − r)³.</summary>
        public static double SpikySlope(double r, double h)
        {
            return r < h ? -3.0 * 15.0 / (Math.PI * Math.Pow(h, 6)) * Math.Pow(h - r, 2) : 0.0;
        }

        /// <summary>Equation (17).</summary>
        public static double ViscosityLaplacian(double r, double h)
        {
            return r < h ? 45.0 / (Math.PI * Math.Pow(h, 6)) * (h - r) : 0.0;
        }

        /// <summary>Pairs within h, [i] holding the others of i in ascending order.</summary>
        public static List<int>[] Neighbours(IReadOnlyList<FluidParticle> particles, double h)
        {
            var lists = new List<int>[particles.Count];
            for (int i = 0; i < lists.Length; i++)
            {
                lists[i] = new List<int>();
                for (int j = 0; j < lists.Length; j++)
                {
                    if (i != j && Distance(particles[i], particles[j]) < h) lists[i].Add(j);
                }
            }

            return lists;
        }

        public static double Distance(in FluidParticle a, in FluidParticle b)
        {
            return ((Double3)a.Position - b.Position).Length;
        }

        /// <summary>From b to a: the shortest of all images of b that a box periodic along some axes has around a.</summary>
        /// <param name="a">A particle.</param>
        /// <param name="b">Another.</param>
        /// <param name="period">Length of the box [m]; zero along axes with walls.</param>
        public static Double3 Separation(in FluidParticle a, in FluidParticle b, Vector3 period)
        {
            Double3 d = (Double3)a.Position - b.Position;
            return new Double3(Shortest(d.X, period.x), Shortest(d.Y, period.y), Shortest(d.Z, period.z));
        }

        private static double Shortest(double d, double period)
        {
            double best = d;
            for (int image = -1; image <= 1; image += 2)
            {
                double other = d + image * period;
                best = Math.Abs(other) < Math.Abs(best) ? other : best;
            }

            return best;
        }

        /// <summary>Equation (11) for particle i.</summary>
        public static double Density(IReadOnlyList<FluidParticle> particles, int i, in FluidSolverSettings settings)
        {
            Vector3 period = settings.PeriodLength;
            double sum = 0.0;
            for (int j = 0; j < particles.Count; j++)
            {
                if (j != i || settings.Own<ThesisSettings>().SelfDensity)
                {
                    sum += settings.ParticleMass * Poly6(Separation(particles[i], particles[j], period).Length, settings.SupportRadius);
                }
            }

            return sum;
        }

        /// <summary>Equation (10).</summary>
        public static double Pressure(double density, in FluidSolverSettings settings)
        {
            double pressure = settings.Own<ThesisSettings>().Stiffness * (density - settings.RestDensity);
            return settings.PressureClamp ? Math.Max(0.0, pressure) : pressure;
        }

        /// <summary>Force density on particle i: equation (13) with the spiky gradient, plus (15) with the Laplacian (17).</summary>
        /// <param name="particles">Particles.</param>
        /// <param name="density">Their densities.</param>
        /// <param name="pressure">Their pressures.</param>
        /// <param name="i">Index of the particle.</param>
        /// <param name="settings">The physics.</param>
        /// <param name="magnitude">Sum of the magnitudes of all terms: what rounding errors are proportional to.</param>
        public static Double3 Force(IReadOnlyList<FluidParticle> particles, IReadOnlyList<float> density,
            IReadOnlyList<float> pressure, int i, in FluidSolverSettings settings, out double magnitude)
        {
            double h = settings.SupportRadius;
            double half = settings.Own<ThesisSettings>().PressureHalf ? 0.5 : 1.0;
            Double3 force = Double3.Zero;
            magnitude = 0.0;
            for (int j = 0; j < particles.Count; j++)
            {
                Double3 separation = Separation(particles[i], particles[j], settings.PeriodLength);
                double r = separation.Length;
                if (j == i || r >= h) continue;

                Double3 towardsI = r > 1e-6 * h
                    ? separation / r
                    : new Double3(particles[i].Id < particles[j].Id ? 1.0 : -1.0, 0.0, 0.0);
                double volume = settings.ParticleMass / density[j];
                Double3 pressureTerm = -half * (pressure[i] + pressure[j]) * volume * SpikySlope(r, h) * towardsI;
                Double3 viscosityTerm = settings.Viscosity * volume * ViscosityLaplacian(r, h)
                    * ((Double3)particles[j].VelT0 - particles[i].VelT0);
                force += pressureTerm + viscosityTerm;
                magnitude += pressureTerm.Length + viscosityTerm.Length;
            }

            return force;
        }
    }
}
