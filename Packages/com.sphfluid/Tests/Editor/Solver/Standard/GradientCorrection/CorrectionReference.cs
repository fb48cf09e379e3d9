using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The gradient correction over all pairs in double precision; symmetric matrices as xx, yy, zz, yz, zx, xy.</summary>
    internal static class CorrectionReference
    {
        /// <summary>Settings with the correction.</summary>
        public static FluidSolverSettings Corrected(in FluidSolverSettings settings) =>
            settings.WithOwn((ref StandardSettings own) => own.GradientCorrection = true);

        /// <summary>Neighbours within R, and the separations from them.</summary>
        public static IEnumerable<(int Other, Double3 Separation)> Near(FluidSolverSettings settings,
            IReadOnlyList<FluidParticle> particles, int i) =>
                Enumerable.Range(0, particles.Count).Where(j => j != i)
                    .Select(j => (j, ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength)))
                    .Where(pair => pair.Item2.Length < settings.SupportRadius);

        /// <summary>
        /// Neighbours within R, and the images of all particles in the walls of the domain, its edges and corners; the separations from
        /// them, and −1 along each axis that is mirrored.
        /// </summary>
        public static IEnumerable<(int Other, Double3 Separation, Double3 Mirror)> Around(FluidSolverSettings settings,
            IReadOnlyList<FluidParticle> particles, int i)
        {
            foreach ((int other, Double3 separation) in Near(settings, particles, i))
            {
                yield return (other, separation, new Double3(1, 1, 1));
            }
            for (int set = 1; set < 27; set++)
            {
                int[] sides = { set % 3, set / 3 % 3, set / 9 }; // of each axis: no image, in the low face, in the high one
                if (!Enumerable.Range(0, 3).All(axis => sides[axis] == 0 || IsWall(settings, axis, sides[axis] == 2))) continue;
                for (int j = 0; j < particles.Count; j++)
                {
                    FluidParticle image = particles[j];
                    for (int axis = 0; axis < 3; axis++)
                    {
                        float twice = (sides[axis] == 2 ? 1f : -1f) * settings.DomainSize[axis];
                        if (sides[axis] > 0) image.Position[axis] = twice - image.Position[axis];
                    }
                    Double3 separation = ThesisReference.Separation(particles[i], image, settings.PeriodLength);
                    if (separation.Length >= settings.SupportRadius) continue;
                    yield return (j, separation, new Double3(sides[0] > 0 ? -1 : 1, sides[1] > 0 ? -1 : 1, sides[2] > 0 ? -1 : 1));
                }
            }
        }

        /// <summary>The density of particles among their images, which add no more than what they are of.</summary>
        public static double Density(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, int i)
        {
            double sum = StandardReference.Kernel(0.0, settings.SupportRadius), images = 0.0;
            foreach ((int _, Double3 d, Double3 mirror) in Around(settings, particles, i))
            {
                double w = StandardReference.Kernel(d.Length, settings.SupportRadius);
                if (IsImage(mirror)) images += w;
                else sum += w;
            }
            return settings.RestDensity + (settings.ParticleMass * (sum + Math.Min(images, sum)) - settings.RestDensity) /
                StandardReference.Response(settings);
        }

        /// <summary>Σ (m/ρ_i)(−W'/r) d dᵀ.</summary>
        public static double[] Moment(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double density, int i)
        {
            double radius = settings.SupportRadius, volume = settings.ParticleMass / Math.Max(density, settings.RestDensity);
            var moment = new double[6];
            foreach ((int _, Double3 d, Double3 _) in Around(settings, particles, i))
            {
                AddProduct(moment, -volume * StandardReference.Slope(d.Length, radius) / d.Length, d);
            }
            return moment;
        }

        /// <summary>The acceleration by the pressure terms of particles and images, corrections included [m/s²].</summary>
        public static Double3 Acceleration(FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double[] density,
            double[][] corrections, int i, double step)
        {
            double c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
            double Term(int k) => Math.Max(0.0, c2 * (density[k] - settings.RestDensity)) / (density[k] * density[k]);
            FluidSolverSettings open = settings; // no wall but the images
            open.Boundaries.Open = FluidFaces.All & ~FluidBoundaries.FacesOf(settings.Boundaries.Periodic);
            Double3 sum = StandardReference.Acceleration(particles, density, i, open), slopes = Double3.Zero, faces = Double3.Zero;
            foreach ((int j, Double3 d, Double3 mirror) in Around(settings, particles, i))
            {
                double slope = settings.ParticleMass * StandardReference.Slope(d.Length, settings.SupportRadius) / d.Length /
                    StandardReference.Response(settings);
                Double3 push = -slope * (Term(i) * Times(corrections[i], d) + Term(j) * Times(Mirrored(corrections[j], mirror), d));
                if (IsImage(mirror)) push -= slope * (Term(i) + Term(j)) * d;
                sum += push;
                faces += new Double3(mirror.X < 0 ? push.X : 0, mirror.Y < 0 ? push.Y : 0, mirror.Z < 0 ? push.Z : 0);
                slopes += slope / settings.RestDensity * d; // over M
            }
            double Square(int axis) => HasFaceWithin(settings, particles[i], axis) ? slopes[axis] * slopes[axis] : 0.0;
            double way = settings.SoundSpeed * step * Math.Sqrt(Square(0) + Square(1) + Square(2)); // square to the faces alone
            return sum - (1.0 - 1.0 / (1.0 + Math.Max(way * way - 0.03, 0.0))) * faces; // Euler's implicit rule
        }

        /// <summary>A regularised inverse of a moment over M, less the identity, by Jacobi's rotations.</summary>
        public static double[] Correction(double[] mean)
        {
            double[] x = Eigenvalues(mean, out Double3[] axes);
            double t = Math.Max(0.0, Math.Min(1.0, (x.Min() - 0.2) / 0.25)), weight = t * t * (3.0 - 2.0 * t);
            var correction = new double[6];
            for (int k = 0; k < 3; k++) AddProduct(correction, weight * (1.0 / Math.Max(x[k], 0.77) - 1.0), axes[k]);
            return correction;
        }

        /// <summary>Shepard's mean of moments about a particle, itself included.</summary>
        public static double[] Mean(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double[][] moments, int i)
        {
            double weight = StandardReference.Kernel(0.0, settings.SupportRadius);
            double[] sum = moments[i].Select(m => weight * m).ToArray();
            foreach ((int j, Double3 d, Double3 mirror) in Around(settings, particles, i))
            {
                double w = StandardReference.Kernel(d.Length, settings.SupportRadius);
                double[] moment = Mirrored(moments[j], mirror);
                weight += w;
                for (int k = 0; k < 6; k++) sum[k] += w * moment[k];
            }
            return sum.Select(s => s / weight).ToArray();
        }

        /// <summary>The offset of a density behind a step [kg/m³].</summary>
        public static double NextOffset(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles, double[] density, int i,
            double[] correction, double offset, double step)
        {
            double rest = settings.RestDensity, radius = settings.SupportRadius, sound = settings.SoundSpeed;
            double volume = settings.ParticleMass / rest, rate = 0.0, work = 0.0;
            Double3 slopes = Double3.Zero;
            foreach ((int j, Double3 d, Double3 mirror) in Around(settings, particles, i))
            {
                Double3 slope = volume * StandardReference.Slope(d.Length, radius) / d.Length * d;
                slopes += slope;
                var seen = (Double3)particles[j].VelT0;
                var image = new Double3(mirror.X * seen.X, mirror.Y * seen.Y, mirror.Z * seen.Z);
                work += rest / StandardReference.Response(settings) *
                    Double3.Dot(Times(correction, slope), (Double3)particles[i].VelT0 - image);
            }
            foreach ((int j, Double3 d) in Near(settings, particles, i))
            {
                bool isPressed = density[i] > rest && density[j] > rest;
                double column = isPressed ? rest / (sound * sound) * Double3.Dot(settings.Gravity, -d) : 0.0;
                double difference = Math.Max(density[j], rest) - Math.Max(density[i], rest) - column;
                rate -= 0.1 * radius * sound * volume * StandardReference.Slope(d.Length, radius) / d.Length * difference;
            }
            double gradient = radius * slopes.Length;
            double flat = Math.Min(gradient, 1.44), most = gradient > 0.15 ? 1.5 * rest * flat * (0.0488 + 0.0966 * flat) : 0.0;
            double filled = Math.Max(0.0, Math.Min(most, offset + Math.Max(0.0, 0.999996 * rest - density[i])));
            if (offset == 0.0) return Math.Max(filled, 1e-6 * rest);
            double target = gradient > 0.3 ? filled : 0.0, below = Math.Min(offset, 0.0) / (0.03 * rest);
            double fading = Math.Min(0.1, Math.Min(1.0, 0.0018 * step * sound / radius) * (1.0 + 20.0 * below * below));
            if (offset > Math.Max(most, 0.01 * rest)) fading = 1.0;
            double threshold = 0.0015 * rest * sound / radius;
            rate += work * work * work / (work * work + threshold * threshold);
            return offset + fading * (target - offset) + step * rate;
        }

        /// <summary>A matrix times a vector.</summary>
        public static Double3 Times(double[] m, Double3 v) => new Double3(
            m[0] * v.X + m[5] * v.Y + m[4] * v.Z, m[5] * v.X + m[1] * v.Y + m[3] * v.Z, m[4] * v.X + m[3] * v.Y + m[2] * v.Z);

        /// <summary>Half floats of a matrix, as InvertMoments stores it.</summary>
        public static uint[] Pack(double[] m) =>
            Enumerable.Range(0, 3).Select(k => Mathf.FloatToHalf((float)m[k]) | (uint)Mathf.FloatToHalf((float)m[k + 3]) << 16).ToArray();

        /// <summary>The matrix of half floats.</summary>
        public static double[] Unpack(uint[] words, int at) => Enumerable.Range(0, 6)
            .Select(k => (double)Mathf.HalfToFloat((ushort)(words[at + k % 3] >> 16 * (k / 3)))).ToArray();

        /// <summary>Adds a factor times d dᵀ.</summary>
        public static void AddProduct(double[] m, double factor, Double3 d)
        {
            for (int k = 0; k < 3; k++)
            {
                m[k] += factor * d[k] * d[k];
                m[k + 3] += factor * d[(k + 1) % 3] * d[(k + 2) % 3];
            }
        }

        private static double[] Eigenvalues(double[] m, out Double3[] axes)
        {
            double[,] a = { { m[0], m[5], m[4] }, { m[5], m[1], m[3] }, { m[4], m[3], m[2] } };
            double[,] v = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
            for (int turn = 0; turn < 40; turn++)
            {
                int p = turn % 3 == 2 ? 1 : 0, q = turn % 3 == 0 ? 1 : 2;
                if (Math.Abs(a[p, q]) < 1e-300) continue;
                double theta = 0.5 * Math.Atan2(2.0 * a[p, q], a[q, q] - a[p, p]), c = Math.Cos(theta), s = Math.Sin(theta);
                for (int k = 0; k < 3; k++) (a[k, p], a[k, q]) = (c * a[k, p] - s * a[k, q], s * a[k, p] + c * a[k, q]);
                for (int k = 0; k < 3; k++) (a[p, k], a[q, k]) = (c * a[p, k] - s * a[q, k], s * a[p, k] + c * a[q, k]);
                for (int k = 0; k < 3; k++) (v[k, p], v[k, q]) = (c * v[k, p] - s * v[k, q], s * v[k, p] + c * v[k, q]);
            }
            axes = Enumerable.Range(0, 3).Select(k => new Double3(v[0, k], v[1, k], v[2, k])).ToArray();
            return new[] { a[0, 0], a[1, 1], a[2, 2] };
        }

        private static bool IsImage(Double3 mirror) => mirror.X + mirror.Y + mirror.Z < 3.0;

        private static double[] Mirrored(double[] m, Double3 mirror) => new[]
            { m[0], m[1], m[2], mirror.Y * mirror.Z * m[3], mirror.Z * mirror.X * m[4], mirror.X * mirror.Y * m[5] };

        private static bool HasFaceWithin(in FluidSolverSettings settings, in FluidParticle particle, int axis)
        {
            float low = particle.Position[axis] + 0.5f * settings.DomainSize[axis], high = settings.DomainSize[axis] - low;
            return IsWall(settings, axis, false) && low < settings.SupportRadius ||
                IsWall(settings, axis, true) && high < settings.SupportRadius;
        }

        private static bool IsWall(in FluidSolverSettings settings, int axis, bool isHigh) => settings.PeriodLength[axis] == 0f &&
            ((int)settings.Boundaries.Open >> 2 * axis & (isHigh ? 2 : 1)) == 0;
    }
}
