using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class MeasureTests
    {
        [Test]
        public void NeighboursOfALatticeAreCounted()
        {
            // 5³ points a unit apart: within 1.5 the centre has 6 + 12 neighbours, and no point has more.
            var points = new Vector3[125];
            for (int i = 0; i < points.Length; i++) points[i] = new Vector3(i % 5, i / 5 % 5, i / 25);

            NeighbourCount count = NeighbourCount.Of(points, 1.5f);

            // Pairs one apart: 3·100; pairs √2 apart: 6·80. Each counts twice.
            Assert.That(count.Maximum, Is.EqualTo(18));
            Assert.That(count.Mean, Is.EqualTo(2.0 * (300 + 480) / 125).Within(1e-12));
            Assert.That(NeighbourCount.Of(new Vector3[0], 1f).Maximum, Is.EqualTo(0));
        }

        // Pairs 0.3 and 0.499 dx apart, one 0.501, one across the faces of cells, and a lattice.
        [Test]
        public void ParticlesWithinHalfASpacingAreCounted()
        {
            const float dx = 0.1f;
            Vector3[] At(params float[] places) => System.Array.ConvertAll(places, x => dx * new Vector3(x, -x, 0.5f * x) / 1.5f);

            ParticleGaps gaps = ParticleGaps.Of(At(-5f, -4.7f, 0f, 0.499f, 3f, 3.501f, 6.9f, 7.2f, 9f), dx);
            Assert.That(gaps.CloseCount, Is.EqualTo(6));
            Assert.That(gaps.CloseShare, Is.EqualTo(6.0 / 9.0).Within(1e-12));
            Assert.That(gaps.Nearest, Is.EqualTo(0.3).Within(0.01).Percent);

            ParticleGaps lattice = ParticleGaps.Of(At(0f, 1.01f, 2.02f, 3.03f), dx);
            Assert.That(lattice.CloseCount, Is.Zero);
            Assert.That(lattice.Nearest, Is.EqualTo(1.0).Within(1e-6));
            Assert.That(ParticleGaps.Of(new Vector3[0], dx).CloseShare, Is.Zero);
            var beyond = new Vector3(float.NaN, 0f, 0f);
            Assert.That(ParticleGaps.Of(new[] { Vector3.zero, beyond, beyond }, dx).CloseCount, Is.Zero);
        }

        [TestCase(0.0, true)]
        [TestCase(0.43, true)]
        [TestCase(0.45, false)]
        [TestCase(5.0, false)]
        [TestCase(double.NaN, false)]
        public void ALiquidIsAtRestWhereItsMotionLiftsItByATenthOfASpacing(double speed, bool atRest)
        {
            // √(2 · 10 m/s² · 0.01 m) = 0.447 m/s.
            var settings = new FluidSolverSettings { Gravity = 10f * Vector3.down, Spacing = 0.1f, TimeStep = 0.001f };
            Assert.That(LiquidVolume.IsAtRest(speed, settings), Is.EqualTo(atRest));
        }

        [Test]
        public void StatisticsNameWhatIsWrong()
        {
            var particles = new[]
            {
                new FluidParticle(Vector3.zero, new Vector3(3, 0, 4), 0),
                new FluidParticle(new Vector3(2, 0, 0), Vector3.zero, 1),
                new FluidParticle(new Vector3(float.NaN, 0, 0), Vector3.zero, 2),
                new FluidParticle(Vector3.zero, new Vector3(0, float.PositiveInfinity, 0), 3),
            };
            FluidSnapshot snapshot =
                FluidSnapshot.FromParticles(particles, new[] { 1020f, 900f, 1000f, 1000f }, new float[4], Matrix4x4.identity);
            var settings =
                new FluidSolverSettings { DomainSize = Vector3.one, TimeStep = 0.001f, RestDensity = 1000f, ParticleMass = 0.5f };

            SnapshotStatistics statistics = SnapshotStatistics.Of(snapshot, settings);

            Assert.That(statistics.NonFiniteCount, Is.EqualTo(2));
            Assert.That(statistics.EscapedCount, Is.EqualTo(1));
            Assert.That(statistics.MaxSpeed, Is.EqualTo(5.0).Within(1e-6));
            Assert.That(statistics.RmsSpeed, Is.EqualTo(Math.Sqrt(12.5)).Within(1e-6));
            Assert.That(statistics.DensityErrorMax, Is.EqualTo(0.02).Within(1e-6));
            Assert.That(statistics.DensityErrorMean, Is.EqualTo(0.01).Within(1e-6));
            Assert.That(statistics.KineticEnergy, Is.EqualTo(0.5 * 0.5 * 25).Within(1e-6));
        }

        [Test]
        public void HashDependsOnTheStateAndNotOnItsOrder()
        {
            var a = new FluidParticle(Vector3.up, Vector3.right, 0);
            var b = new FluidParticle(Vector3.left, Vector3.zero, 1);
            var c = new FluidParticle(Vector3.left, new Vector3(0, 0, 1e-30f), 1);

            Assert.That(HashOf(a, b), Is.EqualTo(HashOf(b, a)));
            Assert.That(HashOf(a, b), Is.Not.EqualTo(HashOf(a, c)));
        }

        private static string HashOf(params FluidParticle[] particles) =>
            FluidSnapshot.FromParticles(particles, new float[particles.Length], new float[particles.Length], Matrix4x4.identity).Hash;
    }
}
