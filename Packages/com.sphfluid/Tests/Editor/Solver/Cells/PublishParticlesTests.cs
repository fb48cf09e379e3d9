using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What drawing and measurements read of the Standard method.</summary>
    public sealed class PublishParticlesTests
    {
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        public void PublishedParticlesCarryWhatTheMethodHolds(int count)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.6f, 0.5f, 0.7f), 0.05f, 0.3f);
            using (var rig = new StandardRig(settings, ParticleSets.Random(count, settings.DomainSize, 1f, 5)))
            {
                rig.Steps(3);
                FluidParticle[] particles = rig.Particles();
                CellBuffers held = rig.State.Buffers;
                Vector4[] positions = GpuTest.Read<Vector4>(held.Positions, count),
                    velocities = GpuTest.Read<Vector4>(held.Velocities, count);
                float[] densities = rig.Densities(), pressures = rig.Pressures();
                float[] density = rig.State.List.Densities.Read<float>(count);
                Vector4[] terms = GpuTest.Read<Vector4>(held.PositionTerms, count);
                for (int i = 0; i < count; i++)
                {
                    Assert.That(particles[i].Position, Is.EqualTo((Vector3)positions[i]), $"position {i}");
                    Assert.That(particles[i].VelT0, Is.EqualTo((Vector3)velocities[i]), $"velocity {i}");
                    Assert.That(particles[i].VelT1, Is.EqualTo((Vector3)velocities[i]), $"second velocity {i}");
                    Assert.That(densities[i], Is.EqualTo(density[i]), $"density {i}");
                    Assert.That(pressures[i], Is.EqualTo(terms[i].w * density[i] * density[i]).Within(1e-3).Percent, $"pressure {i}");
                }
                Assert.That(particles.Select(p => p.Id).OrderBy(id => id), Is.EqualTo(Enumerable.Range(0, count).Select(i => (uint)i)));
            }
        }
    }
}
