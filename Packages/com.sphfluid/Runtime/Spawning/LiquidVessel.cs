using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a vessel of liquid is made from, in simulation space.</summary>
    internal struct VesselInput
    {
        /// <summary>A point in the hollow [m].</summary>
        public Vector3 Seed;

        /// <summary>Unit vector against gravity.</summary>
        public Vector3 Up;

        /// <summary>Height of the surface above the seed [m].</summary>
        public float Level;

        /// <summary>Whether the domain's faces hold the liquid too.</summary>
        public bool DomainHolds;

        /// <summary>Domain edge lengths [m].</summary>
        public Vector3 DomainSize;

        /// <summary>The colliders.</summary>
        public CollisionScene Colliders;

        /// <summary>Distance from a triangle below which a site is left out [m].</summary>
        public float Clearance;
    }

    /// <summary>The hollow of the colliders round a point, up to a level: the sites that a flood from the point reaches.</summary>
    internal sealed class LiquidVessel : LiquidShape
    {
        readonly VesselInput input;
        SpawnLattice lattice;
        VesselFlood flood;

        /// <summary>The hollow round a seed; empty until it is fitted to a lattice.</summary>
        public LiquidVessel(string name, in VesselInput input, Vector3 velocity) : base(name, FrameOf(new Bounds(input.Seed, Vector3.zero)), velocity)
        {
            this.input = input;
        }

        /// <inheritdoc/>
        public override double Volume => flood == null ? 0.0 : flood.Count * Math.Pow(lattice.Spacing, 3);

        /// <summary>How the liquid gets out; null where it stays.</summary>
        public VesselLeak? Leak => flood?.Leak;

        /// <summary>Whether the grid of cells is larger than can be flooded.</summary>
        public bool IsTooFine => flood != null && flood.IsTooFine;

        /// <inheritdoc/>
        public override bool Contains(Vector3 point) => flood != null && flood.Contains(point);

        /// <inheritdoc/>
        public override void Fit(in SpawnLattice lattice)
        {
            if (flood != null && this.lattice.Origin == lattice.Origin && this.lattice.Spacing == lattice.Spacing) return;
            this.lattice = lattice;
            flood = new VesselFlood(input, lattice);
            Frame = FrameOf(flood.Bounds);
        }
    }
}
