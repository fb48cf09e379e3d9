using System;
using System.Collections.Generic;
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
        // Of a layer: so little more is no layer.
        private const float WholeTolerance = 0.05f;

        private readonly VesselInput input;
        private SpawnLattice lattice;
        private VesselFlood flood;
        private double volume;

        /// <summary>The hollow round a seed; empty until it is fitted to a lattice.</summary>
        public LiquidVessel(string name, in VesselInput input, Vector3 velocity)
            : base(name, FrameOf(new Bounds(input.Seed, Vector3.zero)), velocity)
        {
            this.input = input;
        }

        /// <inheritdoc/>
        public override double Volume => volume;

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
            (Sites, volume) = (Array.Empty<Vector3>(), 0.0);
            flood = new VesselFlood(input, lattice);
            if (flood.Count > 0) flood = new VesselFlood(input, Laid(flood.Hollow, lattice.Spacing));
            if (flood.Count > 0)
            {
                List<Vector3> places = flood.Places(out volume);
                if (places.Count == 0) places.Add(input.Seed); // wholly in a collider, which is then named
                Sites = places;
            }
            Frame = FrameOf(flood.Bounds);
        }

        // As many layers as the hollow touches, shared by both sides.
        private static SpawnLattice Laid(in Bounds hollow, float spacing)
        {
            Vector3 origin = Vector3.zero;
            for (int axis = 0; axis < 3; axis++)
            {
                origin[axis] = hollow.center[axis] - 0.5f * spacing * Mathf.Ceil(hollow.size[axis] / spacing - WholeTolerance);
            }
            return new SpawnLattice(origin, spacing);
        }
    }
}
