using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Counts of the GPU's statistics stay exact when many particles count.</summary>
    public sealed class ManyBadParticlesTests
    {
        private const float Spacing = 0.04f;

        [Test]
        public void EveryBadParticleCountsOnce()
        {
            const int count = 600, notFinite = 120, outside = 130;
            Vector3 domain = new Vector3(0.8f, 0.6f, 0.7f);
            FluidSolverSettings settings = TestSettings.ByRule(domain, Spacing);
            FluidShaderSet shaders = TestShaders.CreateSet();
            FluidParticle[] particles = ParticleSets.Random(count, 0.9f * domain, 0f, 7);
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                for (int i = 0; i < notFinite; i++) particles[i].Position.y = i % 2 == 0 ? float.NaN : float.NegativeInfinity;
                for (int i = notFinite; i < notFinite + outside; i++)
                {
                    particles[i].Position = new Vector3(0f, 0f, (i % 2 == 0 ? -1f : 1f) * (0.5f * domain.z + Spacing));
                }
                solver.Particles.SetData(particles);
                FluidStatistics found = meter.MeasureNow();
                Assert.That(found.NonFinite, Is.EqualTo(notFinite));
                Assert.That(found.Escaped, Is.EqualTo(outside));
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
