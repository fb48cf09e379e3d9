using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The field of the sparse surface in double precision, by brute force over all particles; written from the
    /// formulas, not from the shaders.
    /// </summary>
    internal sealed class SurfaceFieldReference
    {
        private readonly SurfaceFieldSettings field;
        private readonly SurfaceGrid grid;
        private readonly FluidSolverSettings settings;
        private readonly Double3[] centres;
        private readonly double[] volumes; // in dx³
        private readonly double[] sprays;
        private readonly Double3[] apart; // from a kernel's centre to the two that stand for it; zero for one
        private readonly Covariance[] shapes; // of stretched kernels; null where all are round
        private readonly Dictionary<Vector3Int, double> raw = new Dictionary<Vector3Int, double>();

        public SurfaceFieldReference(IReadOnlyList<FluidParticle> particles, in FluidSolverSettings settings,
            in SurfaceFieldSettings field, SurfaceGrid grid)
        {
            this.field = field;
            this.grid = grid;
            this.settings = settings;
            centres = new Double3[particles.Count];
            volumes = new double[particles.Count];
            sprays = new double[particles.Count];
            apart = new Double3[particles.Count];
            for (int i = 0; i < particles.Count; i++)
            {
                centres[i] = particles[i].Position;
                if (field.IsThesis) volumes[i] = settings.ParticleMass / (settings.RestDensity * Math.Pow(settings.Spacing, 3.0));
            }
            if (field.IsAnisotropic) shapes = new Covariance[particles.Count];
            if (!field.IsThesis) Smooth(particles);
        }

        /// <summary>Where a particle's kernel lies [m].</summary>
        public Double3 Centre(int particle) => centres[particle];

        /// <summary>What a kernel of a particle gives to the field at its centre.</summary>
        public double Weight(int particle) => volumes[particle] * Kernel(0.0) * (IsStretched(particle) ? 0.5 : 1.0);

        /// <summary>From a kernel's centre to each of the two that stand for it [m]; zero where there is one.</summary>
        public Double3 Apart(int particle) => apart[particle];

        /// <summary>Which part of a particle left the surface.</summary>
        public double Spray(int particle) => sprays[particle];

        /// <summary>The value at a sample, -1 to cells + 1 along each axis.</summary>
        public double Value(Vector3Int s)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                if (s[axis] < 0 || s[axis] > grid.Cells[axis]) return 0.0;
            }
            return field.FilterPasses == 0 ? Raw(s) : Math.Max(Filtered(s), Raw(s) - field.UnionOffset);
        }

        // One pass of 1 2 1 is a binomial of three, two passes are one of five.
        private double Filtered(Vector3Int s)
        {
            int reach = field.FilterPasses;
            double[] weights = reach == 1 ? new[] { 0.25, 0.5, 0.25 } : new[] { 0.0625, 0.25, 0.375, 0.25, 0.0625 };
            double sum = 0.0;
            for (int z = -reach; z <= reach; z++)
            {
                for (int y = -reach; y <= reach; y++)
                {
                    for (int x = -reach; x <= reach; x++)
                    {
                        sum += weights[x + reach] * weights[y + reach] * weights[z + reach] * Raw(Mirrored(s + new Vector3Int(x, y, z)));
                    }
                }
            }
            return sum;
        }

        private Vector3Int Mirrored(Vector3Int s)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                if (HasWalls(axis))
                {
                    s[axis] = s[axis] < 0 ? -s[axis] : s[axis] > grid.Cells[axis] ? 2 * grid.Cells[axis] - s[axis] : s[axis];
                }
            }
            return s;
        }

        private double Raw(Vector3Int s)
        {
            if (!raw.TryGetValue(s, out double sum))
            {
                Vector3 cell = grid.CellSize;
                var position = new Double3(grid.Minimum.x + (double)cell.x * s.x, grid.Minimum.y + (double)cell.y * s.y,
                    grid.Minimum.z + (double)cell.z * s.z);
                for (int i = 0; i < centres.Length; i++)
                {
                    Double3 d = Separation(centres[i], position);
                    if (IsStretched(i)) sum += 0.5 * volumes[i] * (Kernel((d + apart[i]).Length) + Kernel((d + -1.0 * apart[i]).Length));
                    else sum += volumes[i] * Kernel(shapes == null ? d.Length : Math.Sqrt(shapes[i].Product(d, d)));
                }
                if (field.WallCompletion) sum /= KernelPartInside(position);
                raw.Add(s, sum);
            }
            return sum;
        }

        private bool IsStretched(int particle) => apart[particle].Length > 0.0;

        private void Smooth(IReadOnlyList<FluidParticle> particles)
        {
            double radius = field.SupportRadius;
            for (int i = 0; i < particles.Count; i++)
            {
                double density = 0.0, weights = 0.0, fellows = 0.0;
                var mean = new Double3(0.0, 0.0, 0.0);
                var moments = new Covariance();
                int count = 0;
                Double3 position = particles[i].Position;
                foreach (FluidParticle other in particles)
                {
                    Double3 d = Separation(other.Position, position);
                    if (d.Length >= radius) continue;
                    double w = 1.0 - Math.Pow(d.Length / radius, 3.0);
                    density += Kernel(d.Length);
                    weights += w;
                    mean += w * d;
                    moments.Add(w, d);
                    count++;
                    if (other.Id != particles[i].Id) fellows += w * Likeness(particles[i].VelT1, other.VelT1);
                }
                var shift = field.Smoothing / weights * mean;
                shift = new Double3(shift.X * Fade(position.X, 0), shift.Y * Fade(position.Y, 1),
                    shift.Z * Fade(position.Z, 2));
                double longest = field.Smoothing * settings.Spacing;
                if (field.HasSpray)
                {
                    double company = Company(density, position);
                    sprays[i] = 1.0 - Step(0.38, 0.60, company + 0.4 * fellows);
                    double part = (1.0 - Step(0.45, 0.75, company)) * Math.Min(fellows, 1.0);
                    apart[i] = longest * InSteps(part * Direction(particles[i].VelT1));
                    longest -= apart[i].Length;
                }
                centres[i] = position + Math.Min(1.0, longest / Math.Max(shift.Length, 1e-30)) * shift;
                volumes[i] = KernelPartInside(position) / density;
                volumes[i] *= 1.0 - sprays[i];
                if (shapes == null) continue;
                moments.Add(-1.0 / weights, mean);
                bool lone = count - 1 <= 6;
                shapes[i] = lone ? Covariance.Ball(0.5) : moments.Stretched(4.0);
                volumes[i] = lone ? 8.0 : 1.0;
            }
        }

        // Of the neighbours, what walls cut off is made up for up to a half.
        private double Company(double density, Double3 position) =>
            Kernel(0.0) + (density - Kernel(0.0)) / Math.Max(KernelPartInside(position), 0.5);

        private static double Likeness(Vector3 own, Vector3 other) =>
            1.0 - Step(0.2, 0.8, ((Double3)(other - own)).Length / Math.Max(((Double3)own).Length, 1e-6));

        private static Double3 Direction(Vector3 velocity)
        {
            Double3 exact = velocity;
            return 1.0 / Math.Max(exact.Length, 1e-6) * exact;
        }

        // As the surface packs it, so that one kernel stands where the reference has one.
        private static Double3 InSteps(Double3 part) =>
            1.0 / 511.0 * new Double3(Math.Round(511.0 * part.X), Math.Round(511.0 * part.Y), Math.Round(511.0 * part.Z));

        private static double Step(double from, double to, double x)
        {
            double t = Math.Min(Math.Max((x - from) / (to - from), 0.0), 1.0);
            return t * t * (3.0 - 2.0 * t);
        }

        private double Kernel(double r) => ThesisReference.Poly6(r, field.SupportRadius) * Math.Pow(settings.Spacing, 3.0);

        private Double3 Separation(Double3 a, Double3 b) =>
            new Double3(Nearest(a.X - b.X, 0), Nearest(a.Y - b.Y, 1), Nearest(a.Z - b.Z, 2));

        private double Nearest(double d, int axis) =>
            HasWalls(axis) ? d : d - settings.DomainSize[axis] * Math.Round(d / settings.DomainSize[axis]);

        private bool HasWalls(int axis) => ((int)settings.Boundaries.Periodic >> axis & 1) == 0;

        private double Fade(double x, int axis)
        {
            double s = (0.5 * settings.DomainSize[axis] - Math.Abs(x)) / field.SupportRadius;
            return !HasWalls(axis) || s > 1.0 ? 1.0 : s < 0.0 ? 0.0 : 3.0 * s * s - 2.0 * s * s * s;
        }

        private double KernelPartInside(Double3 p) =>
            Math.Max(0.125, PartInside(p.X, 0) * PartInside(p.Y, 1) * PartInside(p.Z, 2));

        // Simpson's rule over the slices of the kernel, (1 - x²)⁴ each.
        private double PartInside(double x, int axis)
        {
            if (!HasWalls(axis)) return 1.0;
            double half = 0.5 * settings.DomainSize[axis], radius = field.SupportRadius;
            double low = Math.Max(-1.0, Math.Min(0.0, (-half - x) / radius));
            double high = Math.Min(1.0, Math.Max(0.0, (half - x) / radius));
            return Simpson(low, high) / Simpson(-1.0, 1.0);
        }

        private static double Simpson(double from, double to)
        {
            const int intervals = 64;
            double step = (to - from) / intervals, sum = 0.0;
            for (int i = 0; i <= intervals; i++)
            {
                double x = from + i * step;
                sum += (i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * Math.Pow(1.0 - x * x, 4.0);
            }
            return sum * step / 3.0;
        }
    }
}
