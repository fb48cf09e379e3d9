using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A body of liquid in simulation space, as the spawner needs it.</summary>
    internal abstract class LiquidShape
    {
        /// <summary>Share of the volume that a lattice may miss.</summary>
        private const double GoodMiss = 0.01;

        // Spacings that a shape is wide at least, and particles at most, for a lattice to be fitted to its volume.
        private const float LeastWidth = 9.5f;
        private const double MostFitted = 1e6;

        // Too many can be left out: of too few each counts so much more.
        private const double TooFew = 5.0;

        /// <summary>A shape that lies in the image of the unit cube.</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="frame">Maps the unit cube centred on the origin to a box round the shape [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        protected LiquidShape(string name, Matrix4x4 frame, Vector3 velocity)
        {
            Name = name;
            Frame = frame;
            Velocity = velocity;
        }

        public string Name { get; }
        public Vector3 Velocity { get; }

        /// <summary>Maps the unit cube centred on the origin to a box round the shape [m].</summary>
        public Matrix4x4 Frame { get; protected set; }

        /// <summary>Volume [m³].</summary>
        public abstract double Volume { get; }

        /// <summary>Axis-aligned bounds of <see cref="Frame"/> in simulation space.</summary>
        public Bounds Bounds => new Bounds(Frame.GetColumn(3), 2f * AffineMath.Extents(Frame, 0.5f * Vector3.one));

        /// <summary>Whether the point lies in the liquid.</summary>
        public abstract bool Contains(Vector3 point);

        /// <summary>
        /// Where its particles go [m], those that others take included; null: to the sites of the common lattice that it contains.
        /// </summary>
        public IEnumerable<Vector3> Sites { get; protected set; }

        /// <summary>
        /// Chooses where particles go; called before that is asked for. Where the common lattice misses the volume by more than a
        /// hundredth, it has one of its own about its middle, shifted by half a spacing along some axes, less what is too much of the sites
        /// at the surface.
        /// </summary>
        public virtual void Fit(in SpawnLattice lattice)
        {
            Sites = null;
            float spacing = lattice.Spacing;
            double wanted = Volume / Math.Pow(spacing, 3), best = double.PositiveInfinity;
            if (!IsWide(spacing) || wanted > MostFitted || Math.Abs(On(lattice).Count - wanted) <= GoodMiss * wanted) return;
            List<Vector3> sites = null;
            for (int shift = 0; shift < 8; shift++)
            {
                List<Vector3> found =
                    On(new SpawnLattice(Bounds.center + 0.5f * spacing * new Vector3(shift & 1, shift >> 1 & 1, shift >> 2), spacing));
                double miss = found.Count - wanted;
                if (miss < 0.0) miss *= -TooFew;
                if (miss < best) (sites, best) = (found, miss);
            }
            Sites = Trimmed(sites, (int)Math.Round(wanted), spacing);
        }

        private List<Vector3> Trimmed(List<Vector3> sites, int most, float spacing)
        {
            if (sites.Count <= most) return sites;
            int[] surface = Enumerable.Range(0, sites.Count).Where(i => !IsDeep(sites[i], spacing)).OrderBy(i => PcgHash.Hash((uint)i))
                .Take(sites.Count - most).ToArray();
            var dropped = new HashSet<int>(surface);
            return sites.Where((site, i) => !dropped.Contains(i)).ToList();
        }

        private bool IsDeep(Vector3 site, float spacing)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                Vector3 step = Vector3.zero;
                step[axis] = spacing;
                if (!Contains(site + step) || !Contains(site - step)) return false;
            }
            return true;
        }

        /// <summary>Whether it is wide enough for a lattice to hold its volume: a thinner one has whole layers.</summary>
        protected bool IsWide(float spacing) =>
            Mathf.Min(Frame.GetColumn(0).magnitude, Mathf.Min(Frame.GetColumn(1).magnitude, Frame.GetColumn(2).magnitude)) >=
                LeastWidth * spacing;

        private List<Vector3> On(in SpawnLattice lattice)
        {
            Bounds bounds = Bounds;
            var sites = new List<Vector3>();
            (long first, long last) x = lattice.Range(0, bounds.min.x, bounds.max.x), y = lattice.Range(1, bounds.min.y, bounds.max.y),
                z = lattice.Range(2, bounds.min.z, bounds.max.z);
            for (long k = z.first; k <= z.last; k++)
                for (long j = y.first; j <= y.last; j++)
                    for (long i = x.first; i <= x.last; i++)
                        if (Contains(lattice.Site(i, j, k))) sites.Add(lattice.Site(i, j, k));
            return sites;
        }

        /// <summary>The frame of axis-aligned bounds.</summary>
        protected static Matrix4x4 FrameOf(Bounds bounds) => Matrix4x4.TRS(bounds.center, Quaternion.identity, bounds.size);
    }
}
