using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// KickParticles against sums over all pairs in double precision: all forces but viscosity, and the bound of the viscous matrix.
    /// </summary>
    public sealed class KickParticlesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-4f;

        // Of FluidCounters.hlsl.
        private const int NonFinite = 2;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void VelocitiesChangeByAllForcesButViscosity([Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.Y, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(periodic);
            using (var rig = new StandardStateRig(settings, count))
            {
                Vector3 part = periodic == FluidAxes.All ? Domain : 0.8f * Domain;
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, part, 0.5f, 4));
                double[] density = FillDensities(rig, start);
                rig.FillList(start, listed);
                Vector4[] kicked = Kick(rig);
                FluidSolverSettings thin = settings;
                thin.Viscosity = 0f;
                Double3[] expected = start.Select((_, i) => StandardReference.Acceleration(start, density, i, thin)).ToArray();
                double largest = expected.Max(a => a.Length);
                for (int i = 0; i < count; i++)
                {
                    Double3 measured = ((Double3)(Vector3)kicked[i] - start[i].VelT0) / TimeStep;
                    Assert.That((measured - expected[i]).Length, Is.LessThan(2e-4 * largest + 0.02), $"acceleration of {i}");
                    Assert.That(StandardStateRig.ToBits(kicked[i].w), Is.EqualTo(start[i].Id));
                }
                double bound = new ViscousReference(settings, start, TimeStep).Bound;
                Assert.That(Spectrum(rig)[rig.State.Viscous.Slot], Is.EqualTo(bound).Within(1e-4 * bound));
            }
        }

        // Two slots in turn: each step empties the next one's.
        [Test]
        public void EachStepHasABoundOfItsOwn()
        {
            using (var rig = new StandardStateRig(Settings(FluidAxes.None), 65))
            {
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(65, 0.8f * Domain, 0.5f, 4));
                FillDensities(rig, start);
                rig.FillList(start, true);
                rig.State.RequireViscous();
                rig.State.Viscous.Spectrum.SetData(new[] { StandardStateRig.ToBits(9e9f), 0u });
                Kick(rig);
                float[] first = Spectrum(rig);
                Kick(rig);
                float[] second = Spectrum(rig);
                Assert.That(first[1], Is.Positive.And.LessThan(1e6f));
                Assert.That(first[0], Is.Zero);
                Assert.That(second, Is.EqualTo(new[] { first[1], 0f }));
            }
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void AVelocityThatIsNoNumberIsAtRestBeforeItsNeighboursLearnOfIt(float bad)
        {
            using (var rig = new StandardStateRig(Settings(FluidAxes.None), 1))
            {
                FluidParticle[] start = rig.FillSorted(new[] { new FluidParticle(Vector3.zero, new Vector3(1f, bad, 0f), 5u) });
                rig.SetTerms(new[] { new Vector2(1000f, 0f) });
                rig.FillList(start, true);
                Assert.That((Vector3)Kick(rig)[0], Is.EqualTo(Vector3.zero));
                Assert.That(rig.Counters()[NonFinite], Is.EqualTo(1u));
            }
        }

        private static FluidSolverSettings Settings(FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            settings.Viscosity = 500f;
            settings.Boundaries.Friction = periodic == FluidAxes.All ? 0f : 1f;
            return settings;
        }

        private static Vector4[] Kick(StandardStateRig rig)
        {
            rig.State.RequireViscous();
            var pass = new KickParticlesPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State, new FluidStep(TimeStep, TimeStep, false)));
            return GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, rig.State.ParticleCount);
        }

        private static float[] Spectrum(StandardStateRig rig) =>
            GpuTest.Read<uint>(rig.State.Viscous.Spectrum, 2).Select(StandardStateRig.FromBits).ToArray();

        // Any densities up to 3 % from that at rest, with their pressures.
        private static double[] FillDensities(StandardStateRig rig, FluidParticle[] particles)
        {
            FluidSolverSettings settings = rig.State.Settings;
            double c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
            var random = new System.Random(9);
            double[] density = particles.Select(_ => settings.RestDensity * (0.97 + 0.06 * random.NextDouble())).ToArray();
            rig.SetTerms(density.Select(d => new Vector2((float)d, (float)(Math.Max(0.0, c2 * (d - settings.RestDensity)) / (d * d))))
                .ToArray());
            return density;
        }
    }
}
