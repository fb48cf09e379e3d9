using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Potentials and motion of whitewater by their definitions, over all pairs in double precision; written from the paper, not from the
    /// shaders.
    /// </summary>
    internal sealed class WhitewaterReference
    {
        // Nearer to a threshold than this, rounding decides.
        private const double Doubt = 2e-5;

        private readonly IReadOnlyList<FluidParticle> particles;
        private readonly FluidSolverSettings settings;
        private readonly double radius;

        public WhitewaterReference(IReadOnlyList<FluidParticle> particles, in FluidSolverSettings settings)
        {
            this.particles = particles;
            this.settings = settings;
            radius = settings.SupportRadius;
            Normals = new Double3[particles.Count];
            Air = new double[particles.Count];
            Crest = new double[particles.Count];
            IsDoubtful = new bool[particles.Count];
            for (int i = 0; i < particles.Count; i++) Surround(i);
            var doubtful = (bool[])IsDoubtful.Clone();
            for (int i = 0; i < particles.Count; i++) Bulge(i, doubtful);
        }

        /// <summary>Out of the liquid; zero within.</summary>
        public Double3[] Normals { get; }

        /// <summary>Trapped air [m/s].</summary>
        public double[] Air { get; }

        /// <summary>Wave crest.</summary>
        public double[] Crest { get; }

        /// <summary>Particles that rounding decides about.</summary>
        public bool[] IsDoubtful { get; }

        /// <summary>Kinetic energy [J/kg].</summary>
        public double Energy(int i) => 0.5 * Double3.Dot(particles[i].VelT1, particles[i].VelT1);

        /// <summary>Births that a particle asks for.</summary>
        /// <param name="i">The particle.</param>
        /// <param name="means">Running means of the largest potentials.</param>
        /// <param name="amount">Times the rates.</param>
        /// <param name="duration">s.</param>
        public double Births(int i, Vector3 means, double amount, double duration)
        {
            Vector3 least = WhitewaterPotentialsPass.LeastLimits;
            double air = Part(Air[i], Math.Max(0.4 * means.x, least.x)), crest = Part(Crest[i], Math.Max(0.6 * means.y, least.y));
            return Part(Energy(i), Math.Max(0.2 * means.z, least.z)) * amount * duration *
                (WhitewaterPotentialsPass.AirRate * air + WhitewaterPotentialsPass.CrestRate * crest);
        }

        /// <summary>A piece after a frame; null where rounding decides what it is.</summary>
        public WhitewaterPiece? Move(WhitewaterPiece piece, double duration)
        {
            Double3 from = piece.Position, velocity = piece.Velocity;
            double inset = 0.05 * settings.Spacing;
            Double3 ahead = Wrap(Clamp(from + duration * velocity, inset));
            double count = 0.0, kernels = 0.0;
            bool isDoubtful = false;
            Double3 slope = Double3.Zero, momentum = Double3.Zero;
            foreach (FluidParticle particle in particles)
            {
                Double3 d = Separation(ahead, particle.Position) / radius;
                double q2 = Double3.Dot(d, d), t = 1.0 - q2;
                isDoubtful |= Math.Abs(t) < Doubt;
                if (t <= 0.0) continue;
                count++;
                kernels += t * t * t;
                slope -= 6.0 * t * t * d;
                momentum += t * t * t * (Double3)particle.VelT1;
            }
            double part = Math.Max(BallPart(ahead), 0.25);
            double scaled = count / part * Math.Pow(2.0 * settings.Spacing / radius, 3.0);
            isDoubtful |= Math.Abs(scaled - 6.0) < 1e-3 || Math.Abs(scaled - 20.0) < 1e-3;
            uint kind = scaled < 6.0 ? WhitewaterPiece.Spray : scaled <= 20.0 ? WhitewaterPiece.Foam : WhitewaterPiece.Bubble;
            Double3 around = momentum / Math.Max(kernels, 1e-20), outward = Fade(ahead, -slope);
            Double3 normal = outward / Math.Max(outward.Length, 1e-20), gravity = settings.Gravity, rise = Double3.Zero;
            double ageing = 0.0;
            Double3 next;
            if (kind == WhitewaterPiece.Spray)
            {
                Double3 falling = velocity + duration * gravity;
                next = falling / (1.0 + WhitewaterMotionPass.SprayDrag * falling.Length * duration);
            }
            else if (kind == WhitewaterPiece.Foam)
            {
                next = around;
                double weight = Math.Pow(settings.Spacing / radius, 3.0) * 315.0 / (64.0 * Math.PI);
                double steepness = Math.Max(slope.Length * weight / radius, 0.25 / settings.Spacing);
                double way = Math.Min(Math.Max((kernels * weight / part - 0.5) / steepness, -settings.Spacing), settings.Spacing);
                rise = way * (1.0 - Math.Exp(-duration / WhitewaterMotionPass.SurfaceTime)) * normal;
                ageing = 1.0 + around.Length / WhitewaterMotionPass.FoamSpeed;
            }
            else
            {
                Double3 rising = around - WhitewaterMotionPass.BubbleRise / gravity.Length * gravity;
                next = rising + Math.Exp(-duration / WhitewaterMotionPass.BubbleTime) * (velocity - rising);
                ageing = 0.5;
            }
            Double3 to = from + 0.5 * duration * (velocity + next) + rise, inside = Clamp(to, inset);
            isDoubtful |= IsAtFace(to, inset);
            if ((to - inside).Length > 0.0)
            {
                double slide = kind == WhitewaterPiece.Spray ? 0.6 : 1.0, bounce = kind == WhitewaterPiece.Spray ? -0.2 : -0.2 / 0.6;
                next = new Double3(next.X * (to.X != inside.X ? bounce : slide), next.Y * (to.Y != inside.Y ? bounce : slide),
                    next.Z * (to.Z != inside.Z ? bounce : slide));
                if (kind == WhitewaterPiece.Spray) ageing = piece.Life / 0.2;
            }
            if (isDoubtful) return null;
            bool isLost = !IsWithinOpenFaces(inside);
            return new WhitewaterPiece
            {
                Position = Single(Wrap(inside)),
                Velocity = Single(next),
                Life = isLost ? 0f : (float)(piece.Life - ageing * duration),
                Seed = (piece.Seed & ~3u) | kind,
                Normal = kind == WhitewaterPiece.Spray ? Vector3.zero : Single(normal),
                Age = (float)(piece.Age + duration),
            };
        }

        private void Surround(int i)
        {
            double weights = 1.0, air = 0.0;
            Double3 offset = Double3.Zero;
            for (int j = 0; j < particles.Count; j++)
            {
                Double3 d = Separation(particles[i].Position, particles[j].Position);
                double q = d.Length / radius;
                if (j == i || q >= 1.0 || q == 0.0) continue;
                Double3 v = (Double3)particles[i].VelT1 - particles[j].VelT1;
                double w = 1.0 - q * q * q, cosine = v.Length > 0.0 ? Double3.Dot(v, d) / (v.Length * d.Length) : 0.0;
                air += v.Length * (1.0 - cosine) * (1.0 - q);
                weights += w;
                offset += w / radius * d;
            }
            Double3 mean = Fade(particles[i].Position, offset / weights);
            double reach = mean.Length, s = Math.Min(Math.Max((reach - 0.04) / (0.12 - 0.04), 0.0), 1.0);
            Normals[i] = reach > 0.12 ? mean / reach : Double3.Zero;
            Air[i] = air * s * s * (3.0 - 2.0 * s);
            IsDoubtful[i] = Math.Abs(reach - 0.12) < Doubt;
        }

        private void Bulge(int i, bool[] doubtful)
        {
            Double3 normal = Normals[i], v = particles[i].VelT1;
            if (normal.Length == 0.0) return;
            double forward = Double3.Dot(v, normal) - 0.6 * v.Length;
            IsDoubtful[i] |= Math.Abs(forward) < Doubt;
            for (int j = 0; j < particles.Count; j++)
            {
                Double3 d = Separation(particles[i].Position, particles[j].Position);
                double q = d.Length / radius, below = Double3.Dot(d, normal) / radius;
                if (j == i || q >= 1.0) continue;
                IsDoubtful[i] |= doubtful[j] || Math.Abs(below) < Doubt;
                if (forward >= 0.0 && below > 0.0 && Normals[j].Length > 0.0)
                {
                    Crest[i] += (1.0 - Double3.Dot(normal, Normals[j])) * (1.0 - q);
                }
            }
        }

        private static double Part(double value, double upper) => Math.Min(Math.Max((value / upper - 0.1) / 0.9, 0.0), 1.0);

        private static Vector3 Single(Double3 v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        private bool IsWall(FluidFaces face) =>
            ((settings.Boundaries.Open | FluidBoundaries.FacesOf(settings.Boundaries.Periodic)) & face) == 0;

        private bool IsOpen(FluidFaces face) => (settings.Boundaries.Open & face) != 0;

        // Of the walls [R], 1 at most.
        private double Distance(double x, double size, FluidFaces low, FluidFaces high)
        {
            double nearest = radius;
            if (IsWall(low)) nearest = Math.Min(nearest, x + 0.5 * size);
            if (IsWall(high)) nearest = Math.Min(nearest, 0.5 * size - x);
            return Math.Max(nearest, 0.0) / radius;
        }

        private Double3 Distances(Double3 x) => new Double3(
            Distance(x.X, settings.DomainSize.x, FluidFaces.LowX, FluidFaces.HighX),
            Distance(x.Y, settings.DomainSize.y, FluidFaces.LowY, FluidFaces.HighY),
            Distance(x.Z, settings.DomainSize.z, FluidFaces.LowZ, FluidFaces.HighZ));

        private double BallPart(Double3 x)
        {
            Double3 s = Distances(x);
            double Of(double d) => 0.5 + 0.75 * d - 0.25 * d * d * d; // of a unit ball on the inner side of a plane at distance d
            return Of(s.X) * Of(s.Y) * Of(s.Z);
        }

        private Double3 Fade(Double3 x, Double3 v)
        {
            Double3 s = Distances(x);
            double Of(double d) => d * d * (3.0 - 2.0 * d);
            return new Double3(v.X * Of(s.X), v.Y * Of(s.Y), v.Z * Of(s.Z));
        }

        private double Clamp(double x, double size, FluidFaces low, FluidFaces high, double inset)
        {
            if (IsWall(low)) x = Math.Max(x, -0.5 * size + inset);
            return IsWall(high) ? Math.Min(x, 0.5 * size - inset) : x;
        }

        private Double3 Clamp(Double3 x, double inset) => new Double3(
            Clamp(x.X, settings.DomainSize.x, FluidFaces.LowX, FluidFaces.HighX, inset),
            Clamp(x.Y, settings.DomainSize.y, FluidFaces.LowY, FluidFaces.HighY, inset),
            Clamp(x.Z, settings.DomainSize.z, FluidFaces.LowZ, FluidFaces.HighZ, inset));

        // Where rounding decides whether a face is reached.
        private bool IsAtFace(Double3 x, double inset)
        {
            bool At(double p, double size) => Math.Abs(Math.Abs(p) - 0.5 * size) < Doubt ||
                Math.Abs(Math.Abs(p) - 0.5 * size + inset) < Doubt;
            return At(x.X, settings.DomainSize.x) || At(x.Y, settings.DomainSize.y) || At(x.Z, settings.DomainSize.z);
        }

        private bool IsWithinOpenFaces(Double3 x)
        {
            bool Is(double p, double size, FluidFaces low, FluidFaces high) => !(IsOpen(low) && p < -0.5 * size) &&
                !(IsOpen(high) && p > 0.5 * size);
            return Is(x.X, settings.DomainSize.x, FluidFaces.LowX, FluidFaces.HighX) &&
                Is(x.Y, settings.DomainSize.y, FluidFaces.LowY, FluidFaces.HighY) &&
                Is(x.Z, settings.DomainSize.z, FluidFaces.LowZ, FluidFaces.HighZ);
        }

        private static double Nearest(double d, double period) => period > 0.0 ? d - period * Math.Round(d / period) : d;

        private Double3 Wrap(Double3 x) =>
            new Double3(Nearest(x.X, settings.PeriodLength.x), Nearest(x.Y, settings.PeriodLength.y),
                Nearest(x.Z, settings.PeriodLength.z));

        private Double3 Separation(Double3 a, Double3 b) => Wrap(a - b);
    }
}
