using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Constants by rule, against the numbers of a worked example.</summary>
    public sealed class ThesisRulesTests
    {
        [Test]
        public void WorkedExample()
        {
            // Liquid up to 0.8 m, spacing 25 mm: v = √(2 · 9.81 · 0.8) = 3.96182 m/s, c = 5 v = 19.8091 m/s.
            FluidSolverSettings s = FluidRules.Derive(Example());
            Assert.That(s.MaxSpeed, Is.EqualTo(3.96182).Within(1e-4));
            Assert.That(s.SoundSpeed, Is.EqualTo(19.8091).Within(1e-3));
            Assert.That(s.Own<ThesisSettings>().Stiffness, Is.EqualTo(784.8).Within(1e-2));
            Assert.That(s.TimeStep, Is.EqualTo(0.6 * 1.35 * 0.05 / Math.Sqrt(784.8)).Within(1e-8));
            Assert.That(s.Viscosity, Is.EqualTo(1000.0 * 0.01 * 19.8091 * 0.05).Within(1e-3));
            Assert.That(s.Own<ThesisSettings>().WallDistance, Is.EqualTo(0.0125).Within(1e-7));
            Assert.That(s.Own<ThesisSettings>().WallStiffness, Is.EqualTo(Math.Pow(3.96182 / 0.0125, 2)).Within(10.0));
            Assert.That(s.Own<ThesisSettings>().AccelerationLimit,
                Is.GreaterThan(3.0 * s.Own<ThesisSettings>().WallStiffness * s.Own<ThesisSettings>().WallDistance),
                "far above what contact does");
        }

        [Test]
        public void LatticeSumByHand()
        {
            // κ = 2: the particle, 6 at 1, 12 at √2, 8 at √3; those at 2 have no weight.
            double sum = 64.0 + 6 * 27.0 + 12 * 8.0 + 8 * 1.0;
            Assert.That(MullerKernels.LatticeSum(2.0), Is.EqualTo(sum * 315.0 / (64.0 * Math.PI * 512.0)).Within(1e-12));
        }

        [Test]
        public void MassMakesTheRestLatticeRest()
        {
            FluidSolverSettings s = FluidRules.Derive(Example());
            Assert.That(s.ParticleMass * MullerKernels.LatticeSum(2.0) / Math.Pow(0.025, 3), Is.EqualTo(1000.0).Within(1e-2));
        }

        [Test]
        public void DeepLiquidRaisesTheSoundSpeed()
        {
            FluidRuleInput input = Example();
            input.SoundSpeedRatio = 1f;
            FluidSolverSettings s = FluidRules.Derive(input);
            Assert.That(s.SoundSpeed, Is.EqualTo(Math.Sqrt(9.81 * 0.8 / 0.04)).Within(1e-3), "gH/c² is 4 %");
        }

        [Test]
        public void ViscosityAndWallsLimitTheStep()
        {
            FluidRuleInput input = Example();
            input.KinematicViscosity = 1f;
            FluidSolverSettings s = FluidRules.Derive(input);
            Assert.That(s.TimeStep, Is.EqualTo(0.06 * 0.05 * 0.05 / 1.0).Within(1e-8), "0.06 R²/ν");
            input = Example();
            input.WallStiffnessRatio = 100f;
            s = FluidRules.Derive(input);
            double dt = s.TimeStep;
            Assert.That(s.Own<ThesisSettings>().WallStiffness * dt * dt, Is.LessThan(4.0 - 2.0 * s.Own<ThesisSettings>().WallDamping * dt),
                "k dt² < 4 − 2 c dt");
        }

        [Test]
        public void TheStepIsTheAdvisedOne()
        {
            FluidRuleInput input = Example();
            FluidSolverSettings s = FluidRules.Derive(input);
            Assert.That(s.TimeStep, Is.EqualTo(FluidRules.Advise(s, 0.0).Step(0.6)).Within(1e-9));
            input.WallStiffnessRatio = 100f;
            s = FluidRules.Derive(input);
            Assert.That(s.TimeStep, Is.EqualTo(FluidRules.Advise(s, 0.0).Walls).Within(1e-9));
        }

        [Test]
        public void AParticleMovesLessThanHalfASpacingInAStep()
        {
            // κ = 4, c = 3 v and the whole acoustic limit would be 1.27 dx a step; 0.4 are kept.
            FluidRuleInput input = Example();
            input.SupportRatio = 4f;
            input.SoundSpeedRatio = 3f;
            input.MaxCompression = 1f;
            input.TimeStepFraction = 1f;
            FluidSolverSettings s = FluidRules.Derive(input);
            Assert.That(s.TimeStep * s.MaxSpeed / s.Spacing, Is.EqualTo(0.4).Within(1e-5));
        }

        [Test]
        public void LiquidAtRestWithoutGravityHasAStep()
        {
            FluidRuleInput input = Example();
            input.Gravity = Vector3.zero;
            Assert.That(FluidRules.Derive(input).TimeStep, Is.GreaterThan(0f).And.LessThan(0.1f));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void BadSpacingIsNamed(float spacing)
        {
            FluidRuleInput input = Example();
            input.Spacing = spacing;
            var error = Assert.Throws<ArgumentException>(() => FluidRules.Derive(input));
            Assert.That(error.Message, Does.Contain("Spacing"));
        }

        private static FluidRuleInput Example()
        {
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = new Vector3(1.8f, 1.2f, 0.8f);
            input.Spacing = 0.025f;
            input.LiquidHeight = 0.8f;
            input.LiquidDepth = 0.8f;
            return input;
        }
    }
}
