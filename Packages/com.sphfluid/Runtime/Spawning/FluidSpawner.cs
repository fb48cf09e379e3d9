using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Fills shapes of liquid with particles. Pure: the same request gives the same particles on every machine.</summary>
    internal static class FluidSpawner
    {
        /// <summary>Least distance of a start position from the domain's faces, as a fraction of the spacing.</summary>
        public const float DomainMargin = 0.2f;

        /// <summary>Largest jitter that keeps every particle inside the domain.</summary>
        public const float MaxJitter = DomainMargin;

        private const double MostSites = 1 << 28;

        /// <summary>Fills the request's shapes.</summary>
        /// <exception cref="ArgumentException">The domain or the spacing is not positive and finite.</exception>
        public static SpawnResult Fill(SpawnRequest request) => Fill(request, null);

        /// <summary>Fills the request's shapes.</summary>
        /// <param name="request">The request.</param>
        /// <param name="placed">Called after each particle that was made; null: nobody is.</param>
        /// <exception cref="ArgumentException">The domain or the spacing is not positive and finite.</exception>
        public static SpawnResult Fill(SpawnRequest request, Action placed)
        {
            var particles = new List<FluidParticle>();
            float fastest = 0f;
            SpawnTally[] tallies = Walk(request, (site, shape) =>
            {
                FluidParticle particle = Particle(request, site, shape, particles.Count);
                particles.Add(particle);
                fastest = Faster(fastest, particle.VelT0);
                placed?.Invoke();
            }, request.MaxParticles, out long needed);
            if (needed > request.MaxParticles) particles.Clear();
            return new SpawnResult(particles, tallies, needed, fastest);
        }

        /// <summary>Counts what <see cref="Fill(SpawnRequest)"/> would make, without making it.</summary>
        /// <exception cref="ArgumentException">The domain or the spacing is not positive and finite.</exception>
        public static SpawnResult Measure(SpawnRequest request)
        {
            float fastest = 0f;
            SpawnTally[] tallies = Walk(request, (site, shape) => fastest = Faster(fastest, Velocity(request, site, shape)),
                request.MaxParticles, out long needed);
            return new SpawnResult(new List<FluidParticle>(), tallies, needed, fastest);
        }

        private static SpawnTally[] Walk(SpawnRequest request, Action<Vector3, LiquidShape> place, long most, out long needed)
        {
            Check(request);
            SpawnLattice lattice = LatticeFit.Fitted(request);
            SpawnTally[] tallies = NewTallies(request);
            needed = 0;
            FindRange(request, lattice, out var x, out var y, out var z);
            double sites = Math.Max(x.last - x.first + 1.0, 0.0) * Math.Max(y.last - y.first + 1.0, 0.0) *
                Math.Max(z.last - z.first + 1.0, 0.0);
            if (sites > MostSites)
            {
                needed = (long)Math.Min(EstimatedCount(request), 1e18);
                return MeasureOutside(request, tallies);
            }

            for (long k = z.first; k <= z.last; k++)
                for (long j = y.first; j <= y.last; j++)
                    for (long i = x.first; i <= x.last; i++) Place(request, lattice.Site(i, j, k), -1, tallies, place, most, ref needed);
            Vector3 half = InnerHalf(request);
            for (int b = 0; b < request.Shapes.Count; b++)
                foreach (Vector3 site in request.Shapes[b].Sites ?? Array.Empty<Vector3>())
                    if (Mathf.Abs(site.x) <= half.x && Mathf.Abs(site.y) <= half.y && Mathf.Abs(site.z) <= half.z)
                    {
                        Place(request, site, b, tallies, place, most, ref needed);
                    }
            return MeasureOutside(request, tallies);
        }

        private static void Place(SpawnRequest request, Vector3 site, int owner, SpawnTally[] tallies, Action<Vector3, LiquidShape> place,
            long most, ref long needed)
        {
            owner = FindOwner(request, site, owner, tallies);
            if (owner < 0) return;
            needed++;
            if (needed <= most) place?.Invoke(site, request.Shapes[owner]);
        }

        private static Vector3 InnerHalf(SpawnRequest request) => request.DomainSize * 0.5f -
            Vector3.one * (DomainMargin * request.Spacing);

        // Every shape that holds the site is asked: the first fills it or finds it covered, later ones share it. A site of a shape of its
        // own is that shape's or nobody's.
        private static int FindOwner(SpawnRequest request, Vector3 site, int only, SpawnTally[] tallies)
        {
            int owner = -1;
            bool taken = false;
            for (int b = 0; b < request.Shapes.Count && (only < 0 || b <= only); b++)
            {
                if (b != only && !request.Shapes[b].Contains(site)) continue;
                if (only < 0 ? request.Shapes[b].Sites != null : b != only)
                {
                    taken = true;
                    continue;
                }
                if (taken)
                {
                    tallies[b].Shared++;
                    continue;
                }
                taken = true;
                int obstacle = request.Obstacle?.Invoke(site) ?? -1;
                if (obstacle >= 0)
                {
                    tallies[b].Carved++;
                    tallies[b].LastObstacle = obstacle;
                    continue;
                }
                tallies[b].Filled++;
                owner = b;
            }
            return owner;
        }

        private static void FindRange(SpawnRequest request, SpawnLattice lattice,
            out (long first, long last) x, out (long first, long last) y, out (long first, long last) z)
        {
            x = y = z = (0, -1);
            Vector3 min = Vector3.positiveInfinity, max = Vector3.negativeInfinity, half = InnerHalf(request);
            foreach (LiquidShape shape in request.Shapes)
                if (shape.Sites == null) (min, max) = (Vector3.Min(min, shape.Bounds.min), Vector3.Max(max, shape.Bounds.max));
            if (min.x > max.x) return;
            (min, max) = (Vector3.Max(min, -half), Vector3.Min(max, half));
            x = lattice.Range(0, min.x, max.x);
            y = lattice.Range(1, min.y, max.y);
            z = lattice.Range(2, min.z, max.z);
        }

        private static SpawnTally[] NewTallies(SpawnRequest request)
        {
            var tallies = new SpawnTally[request.Shapes.Count];
            double cell = Math.Pow(request.Spacing, 3);
            for (int b = 0; b < tallies.Length; b++)
            {
                tallies[b].Expected = request.Shapes[b].Volume / cell;
                tallies[b].LastObstacle = -1;
            }
            return tallies;
        }

        private static SpawnTally[] MeasureOutside(SpawnRequest request, SpawnTally[] tallies)
        {
            for (int b = 0; b < tallies.Length; b++)
            {
                tallies[b].OutsideShare = BoxOverlap.OutsideShare(request.Shapes[b], request.DomainSize);
            }
            return tallies;
        }

        private static double EstimatedCount(SpawnRequest request)
        {
            double volume = 0.0;
            foreach (LiquidShape shape in request.Shapes)
            {
                volume += shape.Volume * (1.0 - BoxOverlap.OutsideShare(shape, request.DomainSize));
            }
            return volume / Math.Pow(request.Spacing, 3);
        }

        private static FluidParticle Particle(SpawnRequest request, Vector3 site, LiquidShape shape, int id)
        {
            float amplitude = Mathf.Clamp(request.Jitter, 0f, MaxJitter) * request.Spacing;
            uint state = PcgHash.Hash((uint)id ^ PcgHash.Hash((uint)request.Seed));
            Vector3 offset = new Vector3(Signed(state), Signed(PcgHash.Hash(state + 1)), Signed(PcgHash.Hash(state + 2))) * amplitude;
            Vector3 velocity = Velocity(request, site + offset, shape);
            return new FluidParticle { Position = site + offset, Id = (uint)id, VelT0 = velocity, VelT1 = velocity };
        }

        private static Vector3 Velocity(SpawnRequest request, Vector3 position, LiquidShape shape) =>
            request.Velocity == null ? shape.Velocity : shape.Velocity + request.Velocity(position);

        // NaN stays: it is for the caller to report.
        private static float Faster(float fastest, Vector3 velocity)
        {
            float speed = velocity.magnitude;
            return speed <= fastest || float.IsNaN(fastest) ? fastest : speed;
        }

        private static float Signed(uint hash) => (hash >> 8) * (2f / 16777216f) - 1f;

        private static void Check(SpawnRequest request)
        {
            Vector3 size = request.DomainSize;
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
            {
                throw new ArgumentException($"The domain size must be positive and finite, but is {size}.", nameof(request));
            }
            if (!AffineMath.IsFinite(request.Spacing) || !(request.Spacing > 0f))
            {
                throw new ArgumentException($"The particle spacing must be positive and finite, but is {request.Spacing}.",
                    nameof(request));
            }
        }
    }
}
