using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Tests
{
    /// <summary>Surface normals and the forces of surface tension over all pairs in double precision.</summary>
    internal static class TensionReference
    {
        /// <summary>R (Σ (m/ρ0) ∇W + (b/2) ∇L) of each particle.</summary>
        public static Double3[] Normals(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double wallShare)
        {
            double radius = settings.SupportRadius;
            var normals = new Double3[particles.Count];
            for (int i = 0; i < normals.Length; i++)
            {
                Double3 sum = 0.5 * wallShare * WallGradient(settings, particles[i].Position);
                foreach ((int _, Double3 d) in Near(settings, particles, i))
                {
                    sum += settings.ParticleMass / (double)settings.RestDensity * StandardReference.Slope(d.Length, radius) / d.Length * d;
                }
                normals[i] = radius * sum;
            }
            return normals;
        }

        /// <summary>Σ (2 p/ρ0²) m ∇W − G Σ (1−q)³ (n_i − n_j) + b (p/ρ0) ∇L of each particle [m/s²].</summary>
        public static Double3[] Accelerations(
            in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, Double3[] normals, double pull, double normalPull,
            double wallShare)
        {
            double radius = settings.SupportRadius, rest = settings.RestDensity;
            var accelerations = new Double3[particles.Count];
            for (int i = 0; i < accelerations.Length; i++)
            {
                Double3 sum = wallShare * pull / rest * WallGradient(settings, particles[i].Position);
                foreach ((int j, Double3 d) in Near(settings, particles, i))
                {
                    double u = 1.0 - d.Length / radius;
                    sum += 2.0 * pull / (rest * rest) * settings.ParticleMass * StandardReference.Slope(d.Length, radius) / d.Length * d;
                    sum -= normalPull * u * u * u * (normals[i] - normals[j]);
                }
                accelerations[i] = sum;
            }
            return accelerations;
        }

        private static IEnumerable<(int Other, Double3 Separation)> Near(FluidSolverSettings settings,
            IReadOnlyList<FluidParticle> particles, int i) =>
                Enumerable.Range(0, particles.Count).Where(j => j != i)
                    .Select(j => (j, ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength)))
                    .Where(pair => pair.Item2.Length < settings.SupportRadius);

        private static Double3 WallGradient(in FluidSolverSettings settings, Double3 p)
        {
            double step = 1e-4 * settings.Spacing;
            return new Double3(
                StandardReference.Walls(p + new Double3(step, 0, 0), settings) -
                    StandardReference.Walls(p - new Double3(step, 0, 0), settings),
                StandardReference.Walls(p + new Double3(0, step, 0), settings) -
                    StandardReference.Walls(p - new Double3(0, step, 0), settings),
                StandardReference.Walls(p + new Double3(0, 0, step), settings) -
                    StandardReference.Walls(p - new Double3(0, 0, step), settings)) / (2.0 * step);
        }
    }
}
