using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid that is stopped at once: what compression stores is lost and not given back.</summary>
    public sealed class ImpactTests
    {
        private const float Spacing = 0.03f;
        private const float Fall = 0.2f;

        // Three layers, as wide as the tank, so that none can get out of the way. Without the loss the centre comes back by 0.87 of the
        // fall.
        [Test]
        public void ASlabThatFallsFlatReboundsByLessThanHalfOfItsFall()
        {
            var counts = new Vector3Int(8, 3, 8);
            var domain = new Vector3(counts.x * Spacing, 0.5f, counts.z * Spacing);
            float rest = 0.5f * (counts.y * Spacing - domain.y);
            FluidParticle[] start = ParticleSets.Lattice(counts, Spacing, 0.02f * Spacing, 3)
                .Select((p, i) => new FluidParticle(p.Position + (rest + Fall) * Vector3.up, Vector3.zero, (uint)i)).ToArray();
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Fall + counts.y * Spacing);
            using (var rig = new StandardRig(settings, start))
            {
                double lowest = Fall, rebound = 0.0;
                for (float time = 0f; time < 0.4f; time += 4f * settings.TimeStep)
                {
                    rig.Steps(4);
                    double height = rig.Particles().Average(p => (double)p.Position.y) - rest;
                    lowest = Math.Min(lowest, height);
                    rebound = height == lowest ? 0.0 : Math.Max(rebound, height);
                }

                Assert.That(lowest, Is.LessThan(0.1f * Fall), "it has fallen");
                Assert.That(rebound, Is.LessThan(0.5f * Fall));
            }
        }
    }
}
