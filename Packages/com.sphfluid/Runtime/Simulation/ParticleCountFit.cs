using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Finds the spacing at which the same liquid has a requested number of particles.</summary>
    internal static class ParticleCountFit
    {
        private const int Iterations = 16, MostWhole = 12;
        private const double GoodMiss = 0.01;

        /// <summary>Spacing for a simulation's liquid volumes and colliders as they are in the scene.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is less than one.</exception>
        /// <exception cref="InvalidOperationException">The domain has no size or holds no liquid, or the simulation is a prefab
        /// asset.</exception>
        public static float Spacing(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, int count)
        {
            if (SceneObjects.IsPrefabAsset(spec.Owner))
            {
                throw new InvalidOperationException(
                    $"'{spec.Name}' is a prefab asset, whose liquid can be measured only in a scene. Place it in one or open the prefab.");
            }
            Vector3 size = spec.DomainSize;
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
            {
                throw new InvalidOperationException($"The domain size of '{spec.Name}' is {size} m; it must be greater than zero.");
            }
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
        /// Spacing for a request: dx ← dx·(N/requested)^⅓ from the volume's own estimate. Counts are steps of dx, so the best of a few
        /// rounds is kept, or one at which a whole number of layers fits an edge: that with the fewest per cent off in number and volume
        /// together.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is less than one.</exception>
        /// <exception cref="InvalidOperationException">The request holds no liquid.</exception>
        public static float Spacing(SpawnRequest request, int count)
        {
            if (count < 1) throw new ArgumentOutOfRangeException(nameof(count), count, "The number of particles must be 1 or more.");
            LatticeFit.Fitted(request);
            double volume = 0.0;
            foreach (LiquidShape shape in request.Shapes)
            {
                volume += shape.Volume * (1.0 - BoxOverlap.OutsideShare(shape, request.DomainSize));
            }
            if (!(volume > 0.0)) throw new InvalidOperationException("There is no liquid in the domain to fit a number of particles to.");

            double spacing = Math.Pow(volume / count, 1.0 / 3.0), best = spacing, bestMiss = double.PositiveInfinity;
            long Try(double candidate)
            {
                request.Spacing = (float)candidate;
                long found = FluidSpawner.Measure(request).Needed;
                double miss = Math.Abs(Math.Log(Math.Max(found, 0.1) / count)) +
                    Math.Abs(Math.Log(Math.Max(found, 0.1) * Math.Pow(candidate, 3.0) / volume));
                if (miss < bestMiss) (best, bestMiss) = (candidate, miss);
                return found;
            }
            for (int i = 0; i < Iterations && bestMiss > GoodMiss; i++) spacing *= Math.Pow(Math.Max(Try(spacing), 0.1) / count, 1.0 / 3.0);
            foreach (double whole in WholeSpacings(request, best))
                if (bestMiss > GoodMiss) Try(whole);
            return (float)best;
        }

        // Between 5 layers and 6 of a narrow tank the rounds above may go to and fro, and 5 be a fifth less liquid.
        private static List<double> WholeSpacings(SpawnRequest request, double spacing)
        {
            var all = new List<double>();
            foreach (LiquidShape shape in request.Shapes)
            {
                if (all.Count >= MostWhole) break;
                for (int axis = 0; axis < 3; axis++)
                {
                    double edge = Math.Min(shape.Bounds.size[axis], request.DomainSize[axis]), layers = Math.Floor(edge / spacing);
                    if (!(layers >= 1.0)) continue;
                    all.Add(edge / layers);
                    all.Add(edge / (layers + 1.0));
                }
            }
            return all;
        }
    }
}
