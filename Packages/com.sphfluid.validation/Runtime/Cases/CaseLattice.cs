using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Particles of the cases' starts: simple cubic lattices, jittered by a seed.</summary>
    public static class CaseLattice
    {
        /// <summary>A block of particles.</summary>
        /// <param name="counts">Particles along each axis.</param>
        /// <param name="spacing">dx [m].</param>
        /// <param name="corner">Lower corner of the block's volume [m]; the first particle is half a spacing inside.</param>
        public static List<Vector3> Box(Vector3Int counts, double spacing, Vector3 corner)
        {
            var positions = new List<Vector3>(counts.x * counts.y * counts.z);
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        positions.Add(corner +
                            new Vector3((float)((x + 0.5) * spacing), (float)((y + 0.5) * spacing), (float)((z + 0.5) * spacing)));
                    }
            return positions;
        }

        /// <summary>A ball about the origin, cut from a lattice that is symmetric to it.</summary>
        /// <param name="radius">Radius [m].</param>
        /// <param name="spacing">dx [m].</param>
        public static List<Vector3> Ball(double radius, double spacing)
        {
            int reach = (int)Math.Ceiling(radius / spacing);
            var positions = new List<Vector3>();
            for (int z = -reach; z < reach; z++)
                for (int y = -reach; y < reach; y++)
                    for (int x = -reach; x < reach; x++)
                    {
                        double px = (x + 0.5) * spacing, py = (y + 0.5) * spacing, pz = (z + 0.5) * spacing;
                        if (px * px + py * py + pz * pz <= radius * radius) positions.Add(new Vector3((float)px, (float)py, (float)pz));
                    }
            return positions;
        }

        /// <summary>Moves each position by normally distributed offsets.</summary>
        /// <param name="positions">The positions, changed.</param>
        /// <param name="deviation">Standard deviation along each axis [m].</param>
        /// <param name="seed">The same seed gives the same offsets.</param>
        /// <param name="inside">Half size of the box that they must not leave [m].</param>
        public static void Jitter(List<Vector3> positions, double deviation, int seed, Vector3 inside)
        {
            if (deviation <= 0.0) return;
            var random = new System.Random(seed);
            for (int i = 0; i < positions.Count; i++)
            {
                var offset = new Vector3(Normal(random), Normal(random), Normal(random));
                Vector3 p = positions[i] + (float)deviation * offset;
                positions[i] = Vector3.Max(-inside, Vector3.Min(inside, p));
            }
        }

        /// <summary>Particles at rest or with a field of velocities, numbered in order.</summary>
        /// <param name="positions">Positions [m].</param>
        /// <param name="velocity">Velocity at a position [m/s]; null for rest.</param>
        public static FluidParticle[] Particles(IReadOnlyList<Vector3> positions, Func<Vector3, Vector3> velocity = null)
        {
            var particles = new FluidParticle[positions.Count];
            for (int i = 0; i < particles.Length; i++)
            {
                particles[i] = new FluidParticle(positions[i], velocity?.Invoke(positions[i]) ?? Vector3.zero, (uint)i);
            }
            return particles;
        }

        /// <summary>A normally distributed number (Box &amp; Muller 1958).</summary>
        internal static float Normal(System.Random random)
        {
            double radius = Math.Sqrt(-2.0 * Math.Log(1.0 - random.NextDouble()));
            return (float)(radius * Math.Cos(2.0 * Math.PI * random.NextDouble()));
        }
    }
}
