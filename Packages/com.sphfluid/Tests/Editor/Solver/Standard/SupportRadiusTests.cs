using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The kernel ends at the support radius, and so does every force.</summary>
    public sealed class SupportRadiusTests
    {
        private const float Spacing = 0.05f;

        // Two particles in free space that pass each other: there is no pressure, so what they feel is viscosity.
        [TestCase(0.5f, true)]
        [TestCase(0.95f, true)]
        [TestCase(1.01f, false)]
        [TestCase(1.05f, false)]
        [TestCase(1.5f, false)]
        public void ParticlesDragEachOtherWithinTheSupportRadiusOnly(float distance, bool drag)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.5f);
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 100f;
            Vector3 place = 0.5f * distance * settings.SupportRadius * Vector3.right;
            var start = new[] { new FluidParticle(-place, Vector3.up, 0u), new FluidParticle(place, Vector3.down, 1u) };
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(1);
                foreach (FluidParticle particle in rig.Particles())
                {
                    float speed = Mathf.Abs(particle.VelT0.y);
                    if (drag)
                        Assert.That(speed, Is.LessThan(1f), $"particle {particle.Id}");
                    else
                        Assert.That(speed, Is.EqualTo(1f), $"particle {particle.Id}");
                }
            }
        }
    }
}
