using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the spawner needs to know: pure data, no scene.</summary>
    internal sealed class SpawnRequest
    {
        /// <summary>Distance of a liquid site from a collider below which it is left out, as a fraction of the spacing.</summary>
        public const float ObstacleClearance = 0.3f;

        /// <summary>Domain edge lengths [m]; the domain is centred on the origin of simulation space.</summary>
        public Vector3 DomainSize { get; set; }

        /// <summary>Faces of the domain that are walls: neither open nor periodic.</summary>
        public FluidFaces Walls { get; set; } = FluidFaces.All;

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing { get; set; }

        /// <summary>Shapes of liquid; an earlier one wins where they overlap.</summary>
        public IReadOnlyList<LiquidShape> Shapes { get; set; } = Array.Empty<LiquidShape>();

        /// <summary>Most particles to make; beyond it none are made and the result only counts.</summary>
        public int MaxParticles { get; set; } = int.MaxValue;

        /// <summary>Seed of the jitter.</summary>
        public int Seed { get; set; }

        /// <summary>Largest random offset of a coordinate as a fraction of the spacing.</summary>
        public float Jitter { get; set; }

        /// <summary>Index of the obstacle that covers a point, or −1; null: no obstacles.</summary>
        public Func<Vector3, int> Obstacle { get; set; }

        /// <summary>Velocity by position that is added to a shape's [m/s]; null: none.</summary>
        public Func<Vector3, Vector3> Velocity { get; set; }
    }

    /// <summary>What became of one shape of liquid.</summary>
    internal struct SpawnTally
    {
        /// <summary>Lattice sites that became particles.</summary>
        public int Filled;

        /// <summary>Sites left to an earlier shape.</summary>
        public int Shared;

        /// <summary>Sites left out because an obstacle covers them.</summary>
        public int Carved;

        /// <summary>Obstacle that covers most recently found carved sites; −1: none.</summary>
        public int LastObstacle;

        /// <summary>Particles that the shape's whole volume would hold, V/dx³.</summary>
        public double Expected;

        /// <summary>Share of the shape's volume outside the domain, 0 to 1.</summary>
        public double OutsideShare;
    }

    /// <summary>Particles of the start, with what was left out.</summary>
    internal sealed class SpawnResult
    {
        internal SpawnResult(List<FluidParticle> particles, SpawnTally[] tallies, long needed, float fastest)
        {
            Fastest = fastest;
            Particles = particles;
            Tallies = tallies;
            Needed = needed;
        }

        /// <summary>Particles in lattice order, ids 0…N−1; empty when <see cref="TooMany"/>.</summary>
        public List<FluidParticle> Particles { get; }

        /// <summary>One entry a shape, in the request's order.</summary>
        public SpawnTally[] Tallies { get; }

        /// <summary>Particles that the shapes need at this spacing.</summary>
        public long Needed { get; }

        /// <summary>Largest speed of a particle [m/s]; not a finite number where a velocity is none.</summary>
        public float Fastest { get; }

        /// <summary>Whether more are needed than the request allows.</summary>
        public bool TooMany => Needed > Particles.Count;
    }
}
