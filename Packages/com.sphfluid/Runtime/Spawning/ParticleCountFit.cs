using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Finds the spacing at which the same liquid has a requested number of particles.</summary>
    internal static class ParticleCountFit
    {
        const int Iterations = 16;

        /// <summary>Spacing for a simulation's liquid volumes and colliders as they are in the scene.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is less than one.</exception>
        /// <exception cref="InvalidOperationException">The domain has no size or holds no liquid, or the simulation is a prefab asset.</exception>
        public static float Spacing(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, int count)
        {
            if (SceneObjects.IsPrefabAsset(spec.Owner))
                throw new InvalidOperationException(
                    $"'{spec.Name}' is a prefab asset, whose liquid can be measured only in a scene. Place it in one or open the prefab.");
            Vector3 size = spec.DomainSize;
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
                throw new InvalidOperationException($"The domain size of '{spec.Name}' is {size} m; it must be greater than zero.");
            using (var collision = new CollisionScene())
            {
                collision.Gather(spec.Query());
                var shapes = new List<LiquidShape>();
                foreach (VolumeSpec volume in volumes)
                    if (VolumeChecks.Check(volume, spec, collision, new List<FluidMessage>()) is LiquidShape shape) shapes.Add(shape);
                return Spacing(SpawnRequests.For(spec, shapes, collision), count);
            }
        }

        /// <summary>
        /// Spacing for a request: dx ← dx·(N/requested)^⅓ from the volume's own estimate. Counts are steps of dx, so the best
        /// of a few rounds is kept.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is less than one.</exception>
        /// <exception cref="InvalidOperationException">The request holds no liquid.</exception>
        public static float Spacing(SpawnRequest request, int count)
        {
            if (count < 1) throw new ArgumentOutOfRangeException(nameof(count), count, "The number of particles must be 1 or more.");
            LatticeFit.Fitted(request);
            double volume = 0.0;
            foreach (LiquidShape shape in request.Shapes) volume += shape.Volume * (1.0 - BoxOverlap.OutsideShare(shape, request.DomainSize));
            if (!(volume > 0.0)) throw new InvalidOperationException("There is no liquid in the domain to fit a number of particles to.");

            double spacing = Math.Pow(volume / count, 1.0 / 3.0), best = spacing;
            long bestMiss = long.MaxValue;
            for (int i = 0; i < Iterations && bestMiss > 0; i++)
            {
                request.Spacing = (float)spacing;
                long found = FluidSpawner.Measure(request).Needed;
                long miss = Math.Abs(found - count);
                if (miss < bestMiss)
                {
                    bestMiss = miss;
                    best = spacing;
                }
                spacing *= Math.Pow(Math.Max(found, 0.1) / count, 1.0 / 3.0);
            }
            return (float)best;
        }
    }
}
