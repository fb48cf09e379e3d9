using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The cubic lattice that every liquid volume of a simulation is filled on, so that volumes that touch or overlap
    /// fit together and N particles stand for N·dx³ of liquid.
    /// </summary>
    internal readonly struct SpawnLattice
    {
        /// <summary>A lattice with a cell corner at <paramref name="origin"/>.</summary>
        public SpawnLattice(Vector3 origin, float spacing)
        {
            Origin = origin;
            Spacing = spacing;
        }

        public Vector3 Origin { get; }
        public float Spacing { get; }

        /// <summary>Position of a site: the centre of its cell.</summary>
        public Vector3 Site(long x, long y, long z) => new Vector3(
            (float)(Origin.x + (x + 0.5) * Spacing),
            (float)(Origin.y + (y + 0.5) * Spacing),
            (float)(Origin.z + (z + 0.5) * Spacing));

        /// <summary>First and last site whose coordinate lies in [min, max] on an axis; empty when last is below first.</summary>
        public (long first, long last) Range(int axis, double min, double max)
        {
            double first = Math.Ceiling((min - Origin[axis]) / Spacing - 0.5 - 1e-4);
            double last = Math.Floor((max - Origin[axis]) / Spacing - 0.5 + 1e-4);
            return ((long)Math.Max(first, -1e15), (long)Math.Min(last, 1e15));
        }
    }
}
