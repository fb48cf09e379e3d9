using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AirDrag against double precision, and the flight of a particle alone.</summary>
    public sealed class AirDragTests
    {
        private const float Spacing = 0.05f;
        private const float AirDensity = 100f;

        // 3/4 · 0.47 · 100/(1000 · 1.2407 · 0.05).
        private const double Rate = 0.568227;

        [Test]
        public void VelocitiesFallByWhatIsEmptyAroundThem([Values(1, 63, 64, 65, 1009)] int count)
        {
            const float step = 0.01f;
            FluidSolverSettings settings = Settings();
            var random = new System.Random(5);
            float[] densities = Enumerable.Range(0, count).Select(_ => 100f + 1000f * (float)random.NextDouble()).ToArray();
            Vector4[] before = Enumerable.Range(0, count)
                .Select(i => StandardStateRig.WithW(20f * ParticleSets.RandomVector(random), StandardStateRig.FromBits((uint)i))).ToArray();
            using (var rig = new StandardStateRig(settings, count))
            {
                rig.State.Buffers.Densities.SetData(densities);
                rig.State.Buffers.Velocities.SetData(before);
                GpuTest.Run(cmd => new AirDragPass(rig.Shaders).Record(cmd, rig.State, new FluidStep(step, 0.5f * step, false)));
                Vector4[] after = GpuTest.Read<Vector4>(rig.State.Buffers.Velocities, count);
                double lone = 1000.0 - settings.ParticleMass * 21.0 / (2.0 * Math.PI * Math.Pow(settings.SupportRadius, 3.0));
                for (int i = 0; i < count; i++)
                {
                    Double3 v = (Vector3)before[i];
                    double open = Math.Max(0.0, Math.Min(1.0, 0.9763 * (1000.0 - densities[i]) / lone)); // M at κ = 2.25
                    Double3 expected = v / (1.0 + Rate * open * 0.75 * step * v.Length);
                    Assert.That(((Double3)(Vector3)after[i] - expected).Length, Is.LessThan(2e-5 * v.Length), $"velocity of {i}");
                    Assert.That(StandardStateRig.ToBits(after[i].w), Is.EqualTo((uint)i));
                }
            }
        }

        // 1/v grows by C t.
        [Test]
        public void AParticleAloneFliesAsItsDragSays()
        {
            const int steps = 100;
            FluidSolverSettings settings = Settings();
            using (var rig = new StandardRig(settings, new[] { new FluidParticle(Vector3.zero, 4f * Vector3.right, 0) }))
            {
                rig.Steps(steps);
                double time = (steps - 0.5) * settings.TimeStep;
                Assert.That(rig.Particles()[0].VelT0.x, Is.EqualTo(4.0 / (1.0 + 4.0 * Rate * time)).Within(1e-4));
            }
        }

        [Test]
        public void AirMayBeMissingButNotNegative()
        {
            FluidMethod standard = FluidMethods.Get(FluidMethodKind.Standard);
            FluidSolverSettings With(float air) => Settings().WithOwn((ref StandardSettings own) => own.AirDensity = air);
            Assert.That(() => standard.Check(With(0f)), Throws.Nothing);
            Assert.That(() => standard.Check(With(-1f)), Throws.ArgumentException.With.Message.Contains("AirDensity"));
        }

        private static FluidSolverSettings Settings()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = 4f * Vector3.one;
            input.Spacing = Spacing;
            input.Gravity = Vector3.zero;
            input.InitialSpeed = 4f;
            input.FixedTimeStep = 1e-3f;
            input.AirDensity = AirDensity;
            return FluidRules.Derive(input);
        }
    }
}
