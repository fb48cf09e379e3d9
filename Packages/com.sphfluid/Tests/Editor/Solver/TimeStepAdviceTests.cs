using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Stability limits against numbers by hand, and what is said about them.</summary>
    public sealed class TimeStepAdviceTests
    {
        [Test]
        public void EachLimitByHand()
        {
            TimeStepAdvice advice = FluidRules.Advise(Example(), 2.0);
            Assert.That(advice.Acoustic, Is.EqualTo(3.97748e-3).Within(1e-7), "1.35 · 0.05 / (√200 · 1.2)");
            Assert.That(advice.Speed, Is.EqualTo(5e-3).Within(1e-9), "0.4 · 0.025 / 2");
            Assert.That(advice.Viscosity, Is.EqualTo(15e-3).Within(1e-8), "0.06 · 0.05² / 0.01");
            Assert.That(advice.Walls, Is.EqualTo(5.09587e-3).Within(1e-7), "25600 dt² = 0.9 (4 − 640 dt)");
            Assert.That(advice.Largest, Is.EqualTo(advice.Acoustic));
            Assert.That(advice.Step(0.5), Is.EqualTo(0.5 * advice.Acoustic));
        }

        [TestCase(2.0, 0.01, 25600.0, TimeStepLimit.Acoustic, 3.97748e-3)]
        [TestCase(5.0, 0.01, 25600.0, TimeStepLimit.Speed, 2e-3)]
        [TestCase(2.0, 1.0, 25600.0, TimeStepLimit.Viscosity, 1.5e-4)]
        [TestCase(2.0, 0.01, 1e6, TimeStepLimit.Walls, 8.15342e-4)]
        public void TheSmallestLimits(double speed, double kinematic, double wallStiffness, TimeStepLimit limit, double largest)
        {
            FluidSolverSettings settings = Example();
            settings.Viscosity = (float)(1000.0 * kinematic);
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallStiffness = (float)wallStiffness);
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallDamping = 2f * Mathf.Sqrt(own.WallStiffness));
            TimeStepAdvice advice = FluidRules.Advise(settings, speed);
            Assert.That(advice.Limit, Is.EqualTo(limit));
            Assert.That(advice.Largest, Is.EqualTo(largest).Within(1e-5 * largest));
            double fraction = limit == TimeStepLimit.Acoustic ? 0.9 : 1.0;
            Assert.That(advice.Step(0.9), Is.EqualTo(fraction * advice.Largest), "only the acoustic limit has no margin of its own");
        }

        [Test]
        public void WithoutTheHalfTheWavesAreThoseOfHalfTheStiffness()
        {
            FluidSolverSettings settings = Example();
            settings = settings.WithOwn((ref ThesisSettings own) => own.PressureHalf = false);
            settings = settings.WithOwn((ref ThesisSettings own) => own.Stiffness *= 0.5f);
            Assert.That(FluidRules.Advise(settings, 2.0).Acoustic, Is.EqualTo(3.97748e-3).Within(1e-7));
        }

        [Test]
        public void ForceTimesMassIsAsManyTimesStiffer()
        {
            // m = 0.004 kg, ρ = 1000 kg/m³: four times the acceleration, half the acoustic step, a quarter of the viscous one.
            FluidSolverSettings settings = Example();
            settings = settings.WithOwn((ref ThesisSettings own) => own.ForceTimesMass = true);
            settings.ParticleMass = 0.004f;
            TimeStepAdvice advice = FluidRules.Advise(settings, 0.0);
            Assert.That(advice.Acoustic, Is.EqualTo(0.5 * FluidRules.Advise(Example(), 0.0).Acoustic).Within(1e-8));
            Assert.That(advice.Viscosity, Is.EqualTo(0.25 * 15e-3).Within(1e-8));
        }

        [Test]
        public void AtRestWithoutViscosityAndWallsSoundAloneLimits()
        {
            FluidSolverSettings settings = Example();
            settings.Viscosity = 0f;
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallStiffness = own.WallDamping = 0f);
            TimeStepAdvice advice = FluidRules.Advise(settings, 0.0);
            Assert.That(new[] { advice.Speed, advice.Viscosity, advice.Walls }, Is.All.EqualTo(double.PositiveInfinity));
            Assert.That(advice.Largest * Math.Sqrt(200.0) / 0.05, Is.EqualTo(ThesisRules.AcousticBorder).Within(1e-6));
            Assert.That(advice.Explain(0.6 * advice.Largest), Is.EqualTo(
                "The time step of 2.86 ms is 60 % of the largest stable one, 4.77 ms, which the speed of sound (10 m/s, liquid at 0 m/s) " +
                "sets; " +
                "half of it, by Sound Speed Ratio or in deep liquid Max Compression, would allow 9.55 ms at four times the compression."));
        }

        // What the cure promises is what the changed liquid gets.
        [Test]
        public void CuresDoWhatTheySay()
        {
            FluidSolverSettings viscous = Example();
            viscous.Viscosity = 1000f;
            Assert.That(FluidRules.Advise(viscous, 2.0).Explain(3e-4),
                Does.Contain("is 200 %").And.Contain("viscosity (1 m²/s)").And.Contain("allow 0.3 ms."));
            viscous.Viscosity *= 0.5f;
            Assert.That(FluidRules.Advise(viscous, 2.0).Largest, Is.EqualTo(3e-4).Within(1e-9));

            Assert.That(FluidRules.Advise(Example(), 5.0).Explain(2e-3),
                Does.Contain("fastest particle (5 m/s)").And.Contain("Particle Spacing would allow 3.18 ms."),
                "twice the displacement, but sound allows no more than 3.18 ms");

            FluidSolverSettings hard = Example();
            hard = hard.WithOwn((ref ThesisSettings own) => own.WallStiffness = 1e6f);
            hard = hard.WithOwn((ref ThesisSettings own) => own.WallDamping = 2000f);
            Assert.That(FluidRules.Advise(hard, 2.0).Explain(8e-4),
                Does.Contain("stiffness of the walls").And.Contain("Wall Stiffness Ratio would allow 1.63 ms."));
            hard = hard.WithOwn((ref ThesisSettings own) => own.WallStiffness *= 0.25f);
            hard = hard.WithOwn((ref ThesisSettings own) => own.WallDamping *= 0.5f);
            Assert.That(FluidRules.Advise(hard, 2.0).Largest, Is.EqualTo(1.63068e-3).Within(1e-7));
        }

        [TestCase(-1.0)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void BadSpeedIsRefused(double speed) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => FluidRules.Advise(Example(), speed));

        // c = 10 m/s, R = 5 cm, dx = 2.5 cm, ν = 0.01 m²/s, walls of 160² 1/s² with critical damping.
        private static FluidSolverSettings Example() => new FluidSolverSettings
        {
            Spacing = 0.025f,
            SupportRadius = 0.05f,
            RestDensity = 1000f,
            Viscosity = 10f,
        }.WithOwn(new ThesisSettings { Stiffness = 200f, PressureHalf = true, WallStiffness = 25600f, WallDamping = 320f });
    }
}
