using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.2.6 on pairs in an order that the test makes.</summary>
    public sealed class SortParticlesTests
    {
        [Test]
        public void ParticlesComeInTheOrderOfThePairs([Values(0, 1, 255, 256, 257, 1009)] int count)
        {
            Vector3 domain = Vector3.one;
            var random = new System.Random(count);
            FluidParticle[] particles = ParticleSets.Random(count, domain, 1f, count);
            for (int i = 0; i < count; i++)
            {
                particles[i].Id = (uint)random.Next();
                particles[i].VelT1 = ParticleSets.RandomVector(random);
                particles[i].Removed = i % 2;
                particles[i].DensityOffset = i;
            }

            int[] order = Enumerable.Range(0, count).OrderBy(_ => random.Next()).ToArray();
            using (var rig = new ThesisRig(TestSettings.ByRule(domain, 0.03f), particles))
            {
                int padded = rig.State.Buffers.PaddedCount;
                rig.State.Buffers.Grid.SetData(Enumerable.Range(0, padded).SelectMany(i =>
                    new[] { (uint)i / 3u, i < count ? (uint)order[i] : (uint)i }).ToArray());
                var pass = new SortParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));

                Assert.That(rig.ReadParticles(), Is.EqualTo(order.Select(i => particles[i]).ToArray()));
                FluidParticle[] other = GpuTest.Read<FluidParticle>(rig.State.Buffers.SortedParticles, count);
                Assert.That(other, Is.EqualTo(particles), "the two buffers are exchanged");
            }
        }
    }
}
