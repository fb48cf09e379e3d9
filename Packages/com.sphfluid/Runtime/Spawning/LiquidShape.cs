using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A body of liquid in simulation space, as the spawner needs it.</summary>
    internal abstract class LiquidShape
    {
        /// <summary>Share of the volume that a lattice may miss.</summary>
        const double GoodMiss = 0.01;

        // Spacings that a shape is wide at least, and particles at most, for a lattice to be fitted to its volume.
        const float LeastWidth = 9.5f;
        const double MostFitted = 1e6;

        static readonly float[] Scales = { 1f, 0.995f, 1.005f, 0.99f, 1.01f };

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

        /// <summary>Where its particles go [m], those that others take included; null: to the sites of the common lattice that it contains.</summary>
        public IEnumerable<Vector3> Sites { get; protected set; }

        /// <summary>
        /// Chooses where particles go; called before that is asked for. Where the common lattice misses the volume by more than a hundredth, it goes by
        /// one of its own: shifted by half a spacing along each axis, or a little finer or coarser.
        /// </summary>
        public virtual void Fit(in SpawnLattice lattice)
        {
            Sites = null;
            double wanted = Volume / Math.Pow(lattice.Spacing, 3), best = GoodMiss * wanted;
            if (!IsWide(lattice.Spacing) || wanted > MostFitted || Math.Abs(On(lattice).Count - wanted) <= best) return;
            best = double.PositiveInfinity;
            foreach (float scale in Scales)
                for (int shift = 0; shift < 8; shift++)
                {
                    float step = scale * lattice.Spacing;
                    var origin = Bounds.min + 0.5f * step * new Vector3(shift & 1, shift >> 1 & 1, shift >> 2);
                    List<Vector3> found = On(new SpawnLattice(origin, step));
                    double miss = Math.Abs(found.Count - wanted);
                    if (miss < best) (Sites, best) = (found, miss);
                    if (miss <= 0.5 * GoodMiss * wanted) return;
                }
        }

        /// <summary>Whether it is wide enough for a lattice to hold its volume: a thinner one has whole layers.</summary>
        protected bool IsWide(float spacing) => Mathf.Min(Frame.GetColumn(0).magnitude, Mathf.Min(Frame.GetColumn(1).magnitude, Frame.GetColumn(2).magnitude)) >= LeastWidth * spacing;

        List<Vector3> On(in SpawnLattice lattice)
        {
            Bounds bounds = Bounds;
            var sites = new List<Vector3>();
            (long first, long last) x = lattice.Range(0, bounds.min.x, bounds.max.x), y = lattice.Range(1, bounds.min.y, bounds.max.y), z = lattice.Range(2, bounds.min.z, bounds.max.z);
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
