using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The gates' metrics on drifts made by hand.</summary>
    public sealed class GateMetricTests
    {
        [TestCase(0.5f, 1.1920929e-7 / 2)]
        [TestCase(1f, 1.1920929e-7)]
        [TestCase(-1.5f, 1.1920929e-7)]
        [TestCase(3f, 2 * 1.1920929e-7)]
        public void UlpIsTheDistanceOfFloats(float value, double expected) =>
            Assert.That(RelativeMotionMetric.Ulp(value), Is.EqualTo(expected).Within(1e-6).Percent);

        // dx = 1/64 m: 1e-4 dx = 1.5625e-6 m; 10 ulp at 1.5 m = 1.1921e-6 m. Of 4 particles one is moved, so the centre by a quarter.
        [TestCase(0f, 0.0)]
        [TestCase(2f / 1024 / 1024, 0.75 * 2 / 1024 / 1024 / (1.5625e-6 + 1.1920929e-6))]
        [TestCase(-1f / 1024, 0.75 / 1024 / (1.5625e-6 + 1.1920929e-6))]
        public void RelativeMotionIsOfThePlacesInTheBlock(float moved, double expected)
        {
            var metric = new RelativeMotionMetric(1.0 / 64);
            metric.Sample(0, WallCaseStates.State(4, i => new Vector3(0.015625f * i, 1.5f, 0)));
            metric.Sample(0.5, WallCaseStates.State(4, i => new Vector3(0.015625f * i, -1 + (i == 2 ? moved : 0), 0.25f)));
            metric.Sample(1, WallCaseStates.State(4, i => new Vector3(0.015625f * i, 0, 0)));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(expected).Within(0.1).Percent);
            Assert.That(metric.Evaluate()[1].Value, Is.EqualTo(0.75 * Math.Abs(moved) * 64).Within(0.1).Percent);
        }

        [Test]
        public void MomentumIsOfTheStart()
        {
            var metric = new MomentumMetric();
            metric.Sample(0, Moving(new Vector3(3, 4, 0), new Vector3(0, 0, -5)));
            Assert.That(metric.Evaluate()[0].Value, Is.Zero);
            metric.Sample(1, Moving(new Vector3(0, 4, -5), new Vector3(3, 0, 0)));
            Assert.That(metric.Evaluate()[0].Value, Is.Zero, "what one gives the other has");
            metric.Sample(2, Moving(new Vector3(0, 4.2f, -5), new Vector3(3, 0, 0)));
            metric.Sample(3, Moving(new Vector3(0, 4, -5), new Vector3(3, 0, 0.1f)));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.02).Within(0.001).Percent, "0.2 of 10");
            Assert.That(metric.Series()[0].Y[3], Is.EqualTo(0.01).Within(0.001).Percent);
        }

        [Test]
        public void ASystemAtRestHasNoMomentumToCompareWith()
        {
            var metric = new MomentumMetric();
            metric.Sample(0, Moving(Vector3.zero, Vector3.zero));
            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        [Test]
        public void EnergiesAreThoseOfTheFormulas()
        {
            FluidSolverSettings settings = Settings();
            settings.Gravity = new Vector3(1, -10, 0);
            settings.BodyForce = new FluidBodyForce { RateSquared = new Vector3(0, 0, 4), Centre = new Vector3(0, 0, 0.5f) };
            var particles = new[] { new FluidParticle(new Vector3(0.25f, 2, 1), new Vector3(1, 2, 2), 0),
                new FluidParticle(Vector3.zero, Vector3.zero, 1) };
            LiquidEnergy energy = LiquidEnergy.Of(CaseStates.State(particles, 1100), settings);

            double m = settings.ParticleMass, c = settings.SoundSpeed;
            Assert.That(energy.Kinetic, Is.EqualTo(m * 4.5).Within(1e-4).Percent);
            Assert.That(energy.Potential, Is.EqualTo(m * (-0.25 + 20 + 0.5 + 0.5)).Within(1e-4).Percent);
            Assert.That(energy.Elastic, Is.EqualTo(2 * m * Work(c, 1000, 1100)).Within(0.01).Percent);
            Assert.That(energy.Total, Is.EqualTo(energy.Kinetic + energy.Potential + energy.Elastic));
        }

        [TestCase(true)]
        [TestCase(false)]
        public void SuctionHasEnergyOnlyWhereItActs(bool clamped)
        {
            FluidSolverSettings settings = Settings();
            settings.PressureClamp = clamped;
            LiquidEnergy energy =
                LiquidEnergy.Of(CaseStates.State(new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0) }, 800), settings);

            Assert.That(energy.Elastic, Is.EqualTo(clamped ? 0 : settings.ParticleMass * Work(settings.SoundSpeed, 1000, 800))
                .Within(0.01).Percent);
        }

        [Test]
        public void EnergyGrowsOverTheStateAtRest()
        {
            FluidSolverSettings settings = Settings();
            double m = settings.ParticleMass;
            var metric = new EnergyMetric(settings, 4 * m);
            foreach (double kinetic in new[] { 6.0, 5, 6.5, 4.5 }) // 2, 1, 2.5, 0.5 over rest
                metric.Sample(0, Moving(new Vector3((float)Math.Sqrt(2 * kinetic), 0, 0)));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.25).Within(0.01).Percent);
            Assert.That(metric.Evaluate()[1].Value, Is.EqualTo(0.25).Within(0.01).Percent);
            Assert.That(metric.Series()[0].Y, Is.EqualTo(new[] { 1, 0.5, 1.25, 0.25 }).Within(1e-5));
        }

        // What compresses a unit of mass: ∫ p/ρ² dρ of p = c² (ρ − ρ0), by the midpoint rule.
        private static double Work(double c, double from, double to)
        {
            const int Parts = 10000;
            double sum = 0, width = (to - from) / Parts;
            for (int i = 0; i < Parts; i++)
            {
                double density = from + (i + 0.5) * width;
                sum += c * c * (density - from) / (density * density) * width;
            }
            return sum;
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            settings.Gravity = Vector3.zero;
            return settings;
        }

        private static FluidSnapshot Moving(params Vector3[] velocities) =>
            CaseStates.State(velocities.Select((v, i) => new FluidParticle(Vector3.zero, v, (uint)i)).ToArray());
    }
}
