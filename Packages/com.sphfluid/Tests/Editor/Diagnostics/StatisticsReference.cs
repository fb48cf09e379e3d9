using System;
using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>The statistics by their definitions, by brute force over all pairs in double precision.</summary>
    internal static class StatisticsReference
    {
        public static FluidStatistics Measure(IReadOnlyList<FluidParticle> all, FluidSolverSettings settings, double halfStep = 0.0)
        {
            var whole = new List<FluidParticle>();
            foreach (FluidParticle particle in all)
                if (Finite((Double3)particle.Position) && Finite((Double3)particle.VelT0)) whole.Add(particle);
            var statistics = new FluidStatistics
            {
                ParticleCount = all.Count,
                NonFinite = all.Count - whole.Count,
                Listed = all.Count,
                MinDensityRatio = whole.Count > 0 ? double.PositiveInfinity : 0.0,
                MaxDensityRatio = whole.Count > 0 ? double.NegativeInfinity : -3e38,
            };
            Double3 momentum = Double3.Zero;
            double squares = 0.0, disorder = 0.0, crowd = 0.0;
            int layer = 0;
            for (int i = 0; i < whole.Count; i++)
            {
                Double3 v = whole[i].VelT0, x = whole[i].Position;
                double m = settings.ParticleMass, speed = v.Length;
                Pairs pairs = Around(whole, i, settings);
                double density = Density(all, whole[i], settings);
                momentum += m * v;
                squares += speed * speed;
                statistics.MomentumScale += m * speed;
                statistics.MaxSpeed = Math.Max(statistics.MaxSpeed, speed);
                statistics.KineticEnergy += 0.5 * m * speed * speed;
                statistics.PotentialEnergy += m * Potential(x - halfStep * v, settings);
                statistics.ElasticEnergy += m * Elastic(density, settings);
                double ratio = density / settings.RestDensity;
                statistics.MeanCompression += Math.Max(0.0, ratio - 1.0) / whole.Count;
                statistics.MaxDensityRatio = Math.Max(statistics.MaxDensityRatio, ratio);
                statistics.MinDensityRatio = Math.Min(statistics.MinDensityRatio, ratio);
                statistics.MaxNeighbours = Math.Max(statistics.MaxNeighbours, pairs.Count);
                statistics.Clumped += pairs.Nearest < 0.5 * settings.Spacing ? 1 : 0;
                statistics.Coincident += pairs.Nearest <= 1e-6 * settings.SupportRadius ? 1 : 0;
                statistics.Escaped += Beyond(x, settings) > 0.5 * settings.Spacing ? 1 : 0;
                statistics.AtWalls += ToWall(x, settings) < 0.1 * settings.Spacing ? 1 : 0;
                if (pairs.Count > 0) disorder += Double3.Dot(v - pairs.MeanVelocity, v);
                if (ToWall(x, settings) >= settings.Spacing) continue;
                layer++;
                crowd += 1 + pairs.InWallLayer;
            }
            double kappa = settings.SupportRadius / (double)settings.Spacing;
            statistics.Momentum = new UnityEngine.Vector3((float)momentum.X, (float)momentum.Y, (float)momentum.Z);
            statistics.Checkerboard = squares > 0.0 ? disorder / squares : 0.0;
            statistics.WallCrowding = layer > 0 ? crowd / layer / (Math.PI * kappa * kappa) : 0.0;
            return statistics;
        }

        private struct Pairs
        {
            public double Nearest;
            public int Count, InWallLayer;
            public Double3 MeanVelocity;
        }

        private static Pairs Around(List<FluidParticle> all, int i, in FluidSolverSettings settings)
        {
            double radius = settings.SupportRadius, weights = 0.0;
            Double3 velocity = Double3.Zero;
            var pairs = new Pairs { Nearest = double.PositiveInfinity };
            for (int j = 0; j < all.Count; j++)
            {
                double r = NearestImage((Double3)all[i].Position - all[j].Position, settings).Length;
                if (j == i || r >= radius) continue;
                double weight = Math.Pow(1.0 - r * r / (radius * radius), 3.0);
                pairs.Nearest = Math.Min(pairs.Nearest, r);
                pairs.Count++;
                pairs.InWallLayer += ToWall(all[j].Position, settings) < settings.Spacing ? 1 : 0;
                velocity += weight * (Double3)all[j].VelT0;
                weights += weight;
            }
            pairs.MeanVelocity = velocity / Math.Max(1e-300, weights);
            return pairs;
        }

        // A particle that has a place has mass there, whatever its velocity is.
        private static double Density(IReadOnlyList<FluidParticle> all, in FluidParticle at, in FluidSolverSettings settings)
        {
            double density = 0.0;
            foreach (FluidParticle other in all)
            {
                double r = NearestImage((Double3)at.Position - other.Position, settings).Length;
                if (Finite(other.Position) && (other.Id != at.Id || !FluidMethods.Get(settings.Method).OmitsOwnDensity(settings)))
                {
                    density += settings.ParticleMass * ThesisReference.Poly6(r, settings.SupportRadius);
                }
            }
            return density;
        }

        private static double Potential(Double3 x, in FluidSolverSettings s)
        {
            double energy = 0.0;
            for (int axis = 0; axis < 3; axis++)
            {
                double at = Part(x, axis), from = at - s.BodyForce.Centre[axis];
                if (!IsPeriodic(s, axis)) energy -= s.Gravity[axis] * at;
                energy += 0.5 * s.BodyForce.RateSquared[axis] * from * from;
            }
            return energy;
        }

        // ∫ p/ρ² dρ from the rest density by Simpson's rule.
        private static double Elastic(double density, in FluidSolverSettings s)
        {
            if (!(density > 0.0) || (s.PressureClamp && density <= s.RestDensity)) return 0.0;
            const int steps = 2000;
            double c = s.SoundSpeed, sum = 0.0, h = (density - s.RestDensity) / steps;
            for (int i = 0; i <= steps; i++)
            {
                double rho = s.RestDensity + i * h;
                double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
                sum += weight * c * c * (rho - s.RestDensity) / (rho * rho);
            }
            return sum * h / 3.0;
        }

        private static Double3 NearestImage(Double3 d, in FluidSolverSettings s)
        {
            var part = new double[3];
            for (int axis = 0; axis < 3; axis++)
            {
                part[axis] = Part(d, axis);
                double length = s.DomainSize[axis];
                while (IsPeriodic(s, axis) && part[axis] > 0.5 * length) part[axis] -= length;
                while (IsPeriodic(s, axis) && part[axis] < -0.5 * length) part[axis] += length;
            }
            return new Double3(part[0], part[1], part[2]);
        }

        private static double ToWall(Double3 x, in FluidSolverSettings s)
        {
            double nearest = double.PositiveInfinity;
            for (int axis = 0; axis < 3; axis++)
                if (!IsPeriodic(s, axis)) nearest = Math.Min(nearest, 0.5 * s.DomainSize[axis] - Math.Abs(Part(x, axis)));
            return nearest;
        }

        private static double Beyond(Double3 x, in FluidSolverSettings s)
        {
            double most = double.NegativeInfinity;
            for (int axis = 0; axis < 3; axis++) most = Math.Max(most, Math.Abs(Part(x, axis)) - 0.5 * s.DomainSize[axis]);
            return most;
        }

        private static bool IsPeriodic(in FluidSolverSettings s, int axis) => ((int)s.Boundaries.Periodic >> axis & 1) != 0;

        private static double Part(Double3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;

        private static bool Finite(Double3 v) => !double.IsNaN(v.X + v.Y + v.Z) && !double.IsInfinity(v.X + v.Y + v.Z);
    }
}
