using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a simulation asks of the spawner.</summary>
    internal static class SpawnRequests
    {
        /// <summary>The request for shapes of liquid among the colliders gathered in <paramref name="collision"/>.</summary>
        public static SpawnRequest For(in FluidSpec spec, IReadOnlyList<LiquidShape> shapes, CollisionScene collision)
        {
            float clearance = SpawnRequest.ObstacleClearance * spec.Spacing;
            bool obstacles = collision.Solids.Count > 0;
            return new SpawnRequest
            {
                DomainSize = spec.DomainSize,
                Walls = spec.Boundaries.Walls,
                Spacing = spec.Spacing,
                Shapes = shapes,
                MaxParticles = spec.HasProfile ? spec.Profile.MaxParticles : ProfileSpec.ParticleLimit,
                Seed = spec.Seed,
                Jitter = spec.StartRelaxation == FluidStartRelaxation.None ? spec.StartJitter : 0f,
                Obstacle = obstacles ? point => collision.FindCovering(point, clearance) : (Func<Vector3, int>)null,
                Velocity = spec.VelocityField,
            };
        }
    }
}
